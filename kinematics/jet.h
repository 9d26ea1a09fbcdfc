// Jet: a value and its first three derivatives with respect to one parameter (time, or path
// length).
//
// Schemes are written once as templates over their scalar; with a Jet they deliver velocity,
// acceleration and jerk of the axes exactly, without differences. Products and compositions follow
// Leibniz and Faà di Bruno to third order.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "base/rt_safe.h"

namespace stanok::kinematics {

struct Jet {
  double value = 0.0;
  double first = 0.0;   // per parameter
  double second = 0.0;  // per parameter squared
  double third = 0.0;   // per parameter cubed

  constexpr Jet() = default;
  constexpr Jet(double constant) : value(constant) {}  // NOLINT: a number is a constant jet
  constexpr Jet(double f, double f1, double f2, double f3)
      : value(f), first(f1), second(f2), third(f3) {}
};

[[nodiscard]] constexpr Jet operator-(const Jet& a) RT_SAFE {
  return {-a.value, -a.first, -a.second, -a.third};
}
[[nodiscard]] constexpr Jet operator+(const Jet& a, const Jet& b) RT_SAFE {
  return {a.value + b.value, a.first + b.first, a.second + b.second, a.third + b.third};
}
[[nodiscard]] constexpr Jet operator-(const Jet& a, const Jet& b) RT_SAFE {
  return {a.value - b.value, a.first - b.first, a.second - b.second, a.third - b.third};
}
[[nodiscard]] constexpr Jet operator*(const Jet& a, const Jet& b) RT_SAFE {
  return {
      a.value * b.value, a.first * b.value + a.value * b.first,
      a.second * b.value + 2.0 * a.first * b.first + a.value * b.second,
      a.third * b.value + 3.0 * a.second * b.first + 3.0 * a.first * b.second + a.value * b.third};
}

[[nodiscard]] constexpr Jet operator*(double factor, const Jet& a) RT_SAFE {
  return {factor * a.value, factor * a.first, factor * a.second, factor * a.third};
}

// f(x) from the outer derivatives f', f'', f''' at x (Faà di Bruno).
[[nodiscard]] constexpr Jet compose(const Jet& x, double f, double f1, double f2, double f3)
    RT_SAFE {
  return {f, f1 * x.first, f2 * x.first * x.first + f1 * x.second,
          f3 * x.first * x.first * x.first + 3.0 * f2 * x.first * x.second + f1 * x.third};
}

template <class Scalar>
struct SineCosine {
  Scalar sine;
  Scalar cosine;
};

// Both at once: a rotation needs both, and the derivatives of each are the other. Angle in rad.
[[nodiscard]] inline SineCosine<double> sine_cosine(double angle) RT_SAFE {
  return {std::sin(angle), std::cos(angle)};
}
[[nodiscard]] inline SineCosine<Jet> sine_cosine(const Jet& angle) RT_SAFE {
  const auto [s, c] = sine_cosine(angle.value);
  return {compose(angle, s, c, -s, -c), compose(angle, c, -s, -c, s)};
}
[[nodiscard]] inline Jet sin(const Jet& angle) RT_SAFE {
  return sine_cosine(angle).sine;
}
[[nodiscard]] inline Jet cos(const Jet& angle) RT_SAFE {
  return sine_cosine(angle).cosine;
}

}  // namespace stanok::kinematics

// Vectors of jets, and sums and products of them with vectors of numbers.
template <>
struct Eigen::NumTraits<stanok::kinematics::Jet> : Eigen::GenericNumTraits<double> {
  using Real = stanok::kinematics::Jet;
  using NonInteger = stanok::kinematics::Jet;
  using Nested = stanok::kinematics::Jet;
  using Literal = double;
  // NOLINTNEXTLINE(readability-identifier-naming): Eigen's names
  enum { ReadCost = 4, AddCost = 4, MulCost = 16 };
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<stanok::kinematics::Jet, double, Operation> {
  using ReturnType = stanok::kinematics::Jet;
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, stanok::kinematics::Jet, Operation> {
  using ReturnType = stanok::kinematics::Jet;
};
