#include "base/rotation.h"

#include <cmath>

#include "base/angle.h"

namespace stanok {

Rotation::Rotation(const Matrix& rows) : rows_(rows), identity_(rows == Rotation().rows_) {}

// Rodrigues' formula, with k the unit vector of the axis: R = c*I + (1 - c)*k*k^T + s*[k]x. The
// diagonal is written as c*(1 - k_i^2) + k_i^2 with 1 - k_i^2 from the other two, which is exact
// when k is a coordinate axis.
Rotation Rotation::about(const Vector3<double>& axis, double angle_deg) {
  const double length = std::hypot(axis.x(), axis.y(), axis.z());
  const double x = axis.x() / length;
  const double y = axis.y() / length;
  const double z = axis.z() / length;
  const double s = sine_of_degrees(angle_deg);
  const double c = cosine_of_degrees(angle_deg);
  const double rest = 1.0 - c;
  const Matrix rows{{{c * (y * y + z * z) + x * x, rest * x * y - s * z, rest * x * z + s * y},
                     {rest * x * y + s * z, c * (x * x + z * z) + y * y, rest * y * z - s * x},
                     {rest * x * z - s * y, rest * y * z + s * x, c * (x * x + y * y) + z * z}}};
  return Rotation(rows);
}

Rotation operator*(const Rotation& first, const Rotation& second) {
  if (first.is_identity()) return second;
  if (second.is_identity()) return first;
  Rotation::Matrix rows{};
  for (std::size_t column = 0; column < 3; ++column) {
    const std::array<double, 3> turned = components(first.turned(Vector3<double>{
        second.rows_[0][column], second.rows_[1][column], second.rows_[2][column]}));
    for (std::size_t row = 0; row < 3; ++row) rows[row][column] = turned[row];
  }
  return Rotation(rows);
}

}  // namespace stanok
