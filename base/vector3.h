// Vectors of space: three components along X, Y, Z, numbers or what calculates like them (jets).
//
// Eigen carries them: sums, multiples and cross products are its own, component by component. Sums
// over components are ours (dot, Rotation), as their order is part of the setpoints (ADR 0020).
// A vector without values is zero. What crosses into the cycle by value holds std::array, since
// vectors of Eigen are no plain data; `vector3` and `components` go between the two.
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/rt_safe.h"

#ifndef EIGEN_INITIALIZE_MATRICES_BY_ZERO
#error \
    "base/vector3.h: define EIGEN_INITIALIZE_MATRICES_BY_ZERO; members written as {} must be zero"
#endif

namespace stanok {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

// From X to Z, on every processor and for every scalar.
template <class A, class B>
[[nodiscard]] auto dot(const Vector3<A>& a, const Vector3<B>& b) RT_SAFE {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

[[nodiscard]] inline Vector3<double> vector3(const std::array<double, 3>& components) RT_SAFE {
  return {components[0], components[1], components[2]};
}
[[nodiscard]] inline std::array<double, 3> components(const Vector3<double>& vector) RT_SAFE {
  return {vector.x(), vector.y(), vector.z()};
}

}  // namespace stanok
