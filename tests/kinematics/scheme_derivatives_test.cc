// Values and derivatives of every scheme against its independent reference: positions, velocities,
// accelerations and jerks of the machine axes on cubic motions of the programmed point.
//
// The reference is differentiated numerically in long double: central differences of fourth order
// with a step h of 1/2048. Their truncation, h^4 f^(7), and their rounding, 1e-19 f / h^3, are both
// below 1e-7 of the bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kinematics/test_machines.h"

namespace stanok::kinematics {
namespace {

using reference::Axes;
using reference::Real;

constexpr unsigned derivative_seed = 40105;
constexpr Real h = 1.0L / 2048;
constexpr double clearance_mm = 5.0;  // from singularities

// q(t) = c0 + c1 t + c2 t^2 + c3 t^3 in every axis.
struct CubicMotion {
  std::array<std::array<double, 4>, axes_max> coefficients{};

  [[nodiscard]] AxisVector<Jet> jet() const {  // at t = 0
    AxisVector<Jet> point{};
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      const auto& c = coefficients[axis];
      point[axis] = {c[0], c[1], 2.0 * c[2], 6.0 * c[3]};
    }
    return point;
  }
  [[nodiscard]] Axes at(Real t) const {
    Axes point{};
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      const auto& c = coefficients[axis];
      point[axis] = c[0] + t * (c[1] + t * (c[2] + t * static_cast<Real>(c[3])));
    }
    return point;
  }
};

CubicMotion random_motion(Poses& poses) {
  CubicMotion motion;
  const AxisVector<double> start = poses.next();
  for (std::size_t axis = 0; axis < axes_max; ++axis) {
    motion.coefficients[axis] = {start[axis], poses.between(-60, 60), poses.between(-60, 60),
                                 poses.between(-60, 60)};
  }
  return motion;
}

using Samples = std::array<Axes, 7>;  // at -3h ... 3h

Samples samples(const TestMachine& machine, PointMode mode, const ToolVector& tool,
                const CubicMotion& motion, unsigned winding_axes) {
  const auto map = mode == PointMode::tip ? machine.tip : machine.axes;
  const auto at = [&](Real t) {
    return map(machine.config, motion.at(t), reference::exact(tool.nose_to_tip_mm));
  };
  const Axes middle = at(0);
  Samples all{};
  for (std::size_t n = 0; n < all.size(); ++n) {
    Axes& sample = all[n];
    sample = at((static_cast<Real>(n) - 3) * h);
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      if ((winding_axes >> axis & 1U) == 0) continue;
      sample[axis] -= 360 * std::round((sample[axis] - middle[axis]) / 360);
    }
  }
  return all;
}

// Coefficients of fourth order over seven samples (Fornberg, Generation of finite difference
// formulas on arbitrarily spaced grids, 1988, table 1).
struct Derivatives {
  Real value, first, second, third;

  Derivatives(const Samples& all, std::size_t axis) {
    const auto f = [&](std::size_t n) { return all[n][axis]; };
    value = f(3);
    first = (f(1) - 8 * f(2) + 8 * f(4) - f(5)) / (12 * h);
    second = (-f(1) + 16 * f(2) - 30 * f(3) + 16 * f(4) - f(5)) / (12 * h * h);
    third = (f(0) - 8 * f(1) + 13 * f(2) - 13 * f(4) + 8 * f(5) - f(6)) / (8 * h * h * h);
  }
};

class EverySchemeOnItsReference : public ::testing::TestWithParam<TestMachine> {};

TEST_P(EverySchemeOnItsReference, HasItsPositionsVelocitiesAccelerationsAndJerks) {
  SCOPED_TRACE(::testing::Message() << "seed " << derivative_seed);
  const TestMachine& machine = GetParam();
  const auto scheme = machine.scheme();
  Poses poses(machine, derivative_seed);
  for (int i = 0; i < 4000; ++i) {
    const CubicMotion motion = random_motion(poses);
    const AxisVector<Jet> point = motion.jet();
    AxisVector<double> start{};
    std::ranges::transform(point, start.begin(), &Jet::value);
    if (scheme->distance_to_singularity(start) < clearance_mm) continue;
    const ToolVector tool = i % 4 == 0 ? ToolVector{} : poses.tool();
    const PointMode mode = i % 3 == 0 ? PointMode::axes : PointMode::tip;
    AxisVector<Jet> axes_M{};
    scheme->inverse(mode, tool, point, axes_M);
    const Samples all = samples(machine, mode, tool, motion, scheme->winding_axes());
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      const Derivatives want(all, axis);
      // Derivatives that happen to vanish are judged against the size of the motion: 60 mm/s and
      // 60 deg/s on arms of some 300 mm.
      const auto near = [&](double got, Real expected, double scale) {
        ASSERT_NEAR(got, static_cast<double>(expected), 1e-6 * std::max(scale, std::abs(got)))
            << "axis " << axis << ", motion " << i;
      };
      ASSERT_NEAR(axes_M[axis].value, static_cast<double>(want.value), 1e-10) << "axis " << axis;
      near(axes_M[axis].first, want.first, 100.0);
      near(axes_M[axis].second, want.second, 200.0);
      near(axes_M[axis].third, want.third, 500.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(TestMachines, EverySchemeOnItsReference,
                         ::testing::ValuesIn(test_machines()),
                         [](const auto& machine) { return machine.param.name; });

}  // namespace
}  // namespace stanok::kinematics
