// Rotation of space: an orthogonal matrix that knows when it is none.
//
// The identity leaves every bit of a vector alone, and costs one comparison. Right-handed: a
// positive angle turns counter-clockwise for an observer at whom the axis points. `turned` works
// on anything that adds and can be multiplied by a number, so that derivatives turn with their
// value.
#pragma once

#include <array>

#include "base/rt_safe.h"

namespace stanok {

class Rotation {
 public:
  using Matrix = std::array<std::array<double, 3>, 3>;

  constexpr Rotation() = default;
  // `axis` of any length but zero. Quarter turns about X, Y and Z are exact.
  [[nodiscard]] static Rotation about(const std::array<double, 3>& axis, double angle_deg);

  [[nodiscard]] bool is_identity() const RT_SAFE { return identity_; }
  // Rows; a turned vector is rows * vector.
  [[nodiscard]] const Matrix& rows() const RT_SAFE { return rows_; }

  template <class Scalar>
  [[nodiscard]] std::array<Scalar, 3> turned(const std::array<Scalar, 3>& vector) const RT_SAFE {
    if (identity_) return vector;
    return product(rows_[0], rows_[1], rows_[2], vector);
  }
  template <class Scalar>
  [[nodiscard]] std::array<Scalar, 3> turned_back(const std::array<Scalar, 3>& vector) const
      RT_SAFE {
    if (identity_) return vector;
    return product({rows_[0][0], rows_[1][0], rows_[2][0]}, {rows_[0][1], rows_[1][1], rows_[2][1]},
                   {rows_[0][2], rows_[1][2], rows_[2][2]}, vector);
  }

  // First `second`, then `first`.
  friend Rotation operator*(const Rotation& first, const Rotation& second);
  [[nodiscard]] bool operator==(const Rotation&) const = default;

 private:
  using Row = std::array<double, 3>;

  explicit Rotation(const Matrix& rows);

  template <class Scalar>
  [[nodiscard]] static std::array<Scalar, 3> product(const Row& x, const Row& y, const Row& z,
                                                     const std::array<Scalar, 3>& v) RT_SAFE {
    return {x[0] * v[0] + x[1] * v[1] + x[2] * v[2], y[0] * v[0] + y[1] * v[1] + y[2] * v[2],
            z[0] * v[0] + z[1] * v[1] + z[2] * v[2]};
  }

  Matrix rows_{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  bool identity_ = true;
};

}  // namespace stanok
