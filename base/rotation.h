// Rotation of space: an orthogonal matrix that knows when it is none.
//
// The identity leaves every bit of a vector alone, and costs one comparison. Right-handed: a
// positive angle turns counter-clockwise for an observer at whom the axis points. `turned` works
// on anything that adds and can be multiplied by a number, so that derivatives turn with their
// value.
#pragma once

#include <array>

#include "base/rt_safe.h"
#include "base/vector3.h"

namespace stanok {

class Rotation {
 public:
  using Matrix = std::array<std::array<double, 3>, 3>;

  constexpr Rotation() = default;
  // `axis` of any length but zero. Quarter turns about X, Y and Z are exact.
  [[nodiscard]] static Rotation about(const Vector3<double>& axis, double angle_deg);

  [[nodiscard]] bool is_identity() const RT_SAFE { return identity_; }
  // Rows; a turned vector is rows * vector.
  [[nodiscard]] const Matrix& rows() const RT_SAFE { return rows_; }

  template <class Scalar>
  [[nodiscard]] Vector3<Scalar> turned(const Vector3<Scalar>& v) const RT_SAFE {
    if (identity_) return v;
    const MatrixView R = matrix();
    return R.col(0) * v.x() + R.col(1) * v.y() + R.col(2) * v.z();
  }
  template <class Scalar>
  [[nodiscard]] Vector3<Scalar> turned_back(const Vector3<Scalar>& v) const RT_SAFE {
    if (identity_) return v;
    const MatrixView R = matrix();
    return R.row(0).transpose() * v.x() + R.row(1).transpose() * v.y() +
           R.row(2).transpose() * v.z();
  }

  // First `second`, then `first`.
  friend Rotation operator*(const Rotation& first, const Rotation& second);
  [[nodiscard]] bool operator==(const Rotation&) const = default;

 private:
  using MatrixView = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

  explicit Rotation(const Matrix& rows);

  // Products go by columns: each component is summed up from X to Z (ADR 0020).
  [[nodiscard]] MatrixView matrix() const RT_SAFE { return MatrixView(rows_.front().data()); }

  Matrix rows_{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  bool identity_ = true;
};

}  // namespace stanok
