// X, Y and Z among the axes of a channel: between a point of all axes and a vector of space.
#pragma once

#include "base/axis_index.h"
#include "base/vector3.h"
#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

struct LinearAxes {
  AxisIndex x;
  AxisIndex y;
  AxisIndex z;

  LinearAxes() = default;
  explicit LinearAxes(const std::array<int, 3>& numbers)
      : x(numbers[0]), y(numbers[1]), z(numbers[2]) {}

  // A component whose axis does not exist is 0.
  template <class Scalar>
  [[nodiscard]] Vector3<Scalar> of(const AxisVector<Scalar>& axes) const RT_SAFE {
    return {x.exists() ? axes[x] : Scalar(0.0), y.exists() ? axes[y] : Scalar(0.0),
            z.exists() ? axes[z] : Scalar(0.0)};
  }
  template <class Scalar>
  void set(const Vector3<Scalar>& point, AxisVector<Scalar>& axes) const RT_SAFE {
    if (x.exists()) axes[x] = point.x();
    if (y.exists()) axes[y] = point.y();
    if (z.exists()) axes[z] = point.z();
  }
  // What the axes that exist lose.
  template <class Scalar>
  void subtract(const Vector3<double>& vector, AxisVector<Scalar>& axes) const RT_SAFE {
    if (x.exists()) axes[x] = axes[x] - vector.x();
    if (y.exists()) axes[y] = axes[y] - vector.y();
    if (z.exists()) axes[z] = axes[z] - vector.z();
  }
};

}  // namespace stanok::kinematics
