// Independent reference of the head-table scheme: homogeneous 4x4 chains in long double.
//
// Written from the machine's drawing, not from the formulas of the scheme: the tool chain moves
// from the machine frame through the linear axes, the head and the tool; the workpiece chain
// through the table. Rotations are Rodrigues' formula about a unit vector.
#pragma once

#include <array>
#include <cmath>

namespace stanok::kinematics::reference {

using Real = long double;
using Vector = std::array<Real, 3>;
using Matrix = std::array<std::array<Real, 4>, 4>;

inline Matrix identity() {
  Matrix m{};
  for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1.0L;
  return m;
}

inline Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) product[i][j] += a[i][k] * b[k][j];
  return product;
}

inline Matrix moved(const Vector& by) {
  Matrix m = identity();
  for (std::size_t i = 0; i < 3; ++i) m[i][3] = by[i];
  return m;
}

// Rodrigues: R = I + sin K + (1 - cos) K^2 about the unit vector k.
inline Matrix turned(const Vector& k, Real degrees) {
  const Real angle = degrees * std::acos(-1.0L) / 180.0L;
  const Matrix cross{{{0, -k[2], k[1], 0}, {k[2], 0, -k[0], 0}, {-k[1], k[0], 0, 0}, {0, 0, 0, 0}}};
  const Matrix cross_squared = cross * cross;
  Matrix rotation = identity();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      rotation[i][j] +=
          std::sin(angle) * cross[i][j] + (1.0L - std::cos(angle)) * cross_squared[i][j];
  return rotation;
}

inline Vector position(const Matrix& m) {
  return {m[0][3], m[1][3], m[2][3]};
}

struct HeadTable {
  Vector pivot_to_spindle;
  Vector table_centre;

  // Pivot position that holds the tip at `p` of the table frame: the tool chain hung at the origin
  // says where the tip is relative to the pivot, the workpiece chain where it shall be.
  [[nodiscard]] Vector pivot(const Vector& p, Real head_deg, Real table_deg,
                             const Vector& nose_to_tip) const {
    const Matrix tool_chain =
        turned({0, 1, 0}, head_deg) * moved(pivot_to_spindle) * moved(nose_to_tip);
    const Matrix workpiece_chain = moved(table_centre) * turned({0, 0, 1}, table_deg) * moved(p);
    const Vector tip = position(workpiece_chain);
    const Vector arm = position(tool_chain);
    return {tip[0] - arm[0], tip[1] - arm[1], tip[2] - arm[2]};
  }
};

}  // namespace stanok::kinematics::reference
