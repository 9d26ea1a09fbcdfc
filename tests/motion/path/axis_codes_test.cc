// Integer codes of setpoints against the geometry of rounding and the formulas of the paper
// (V. Kombarov, V. Sorokin, stability of contour feed).
#include "motion/path/axis_codes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/motion/path_samples.h"
#include "tests/support/cycle.h"

namespace stanok::motion::testing {
namespace {

using stanok::testing::cycle_s;

struct CodedCircle {
  double radius = 0.0;       // mm
  double step = 0.0;         // way in a cycle, mm
  double start_angle = 0.0;  // rad
  CodeScale scale;

  [[nodiscard]] double x(int n) const { return radius * std::cos(start_angle + n * step / radius); }
  [[nodiscard]] double y(int n) const { return radius * std::sin(start_angle + n * step / radius); }
};

// Circles fed with less than one increment in a cycle.
CodedCircle slow_circle(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  CodedCircle circle;
  circle.scale.resolution = std::pow(10.0, between(-4.0, -2.0));
  circle.scale.kmv = std::pow(10.0, std::floor(between(3.0, 6.99)));
  circle.radius = between(200.0, 20000.0) * circle.scale.resolution;
  circle.step = between(0.001, 0.999) * circle.scale.resolution;
  circle.start_angle = between(0.0, 2.0 * std::numbers::pi);
  return circle;
}

class SlowCircles : public ::testing::Test {
 protected:
  // Calls `check(circle, n)` for cycles of many circles.
  template <class Check>
  static void visit(const Check& check) {
    const std::uint64_t seed = 11;
    std::mt19937_64 random(seed);
    for (int each = 0; each < 50; ++each) {
      const CodedCircle circle = slow_circle(random);
      for (int n = 1; n <= 2000; ++n) check(circle, n);
      if (HasFailure()) FAIL() << "circle " << each << " of seed " << seed;
    }
  }
};

// The rounded point lies in a square of one increment about the true one: half its diagonal.
TEST_F(SlowCircles, RoundingToNearestKeepsTheRadiusWithinHalfADiagonal) {
  double worst = 0.0;
  double worst_truncated = 0.0;
  visit([&](const CodedCircle& circle, int n) {
    const double z = circle.scale.resolution;
    const auto x = static_cast<double>(position_code(circle.x(n), circle.scale));
    const auto y = static_cast<double>(position_code(circle.y(n), circle.scale));
    EXPECT_LE(std::abs(x - circle.x(n) / z), 0.5 + 1e-9);
    worst = std::max(worst, std::abs(std::hypot(x, y) - circle.radius / z));
    worst_truncated =
        std::max(worst_truncated,
                 std::abs(std::hypot(std::trunc(circle.x(n) / z), std::trunc(circle.y(n) / z)) -
                          circle.radius / z));
  });
  EXPECT_LE(worst, std::numbers::sqrt2 / 2.0 + 1e-9);
  EXPECT_GT(worst, 0.69);            // the bound is reached
  EXPECT_GT(worst_truncated, 1.38);  // what truncation would cost: up to the whole diagonal
}

// Each velocity code is off by half a unit at most, so that their sum follows the position.
TEST_F(SlowCircles, VelocityCodesAddUpToThePosition) {
  double sum = 0.0;
  visit([&](const CodedCircle& circle, int n) {
    if (n == 1) sum = 0.0;
    sum += static_cast<double>(velocity_code(circle.x(n - 1), circle.x(n), circle.scale));
    const auto travelled = static_cast<double>(position_code(circle.x(n), circle.scale) -
                                               position_code(circle.x(0), circle.scale));
    EXPECT_LE(std::abs(sum / circle.scale.kmv - travelled), 1.0 + 0.5 * n / circle.scale.kmv);
  });
}

// Eq. (15) for both axes and rounding to nearest: the contour speed is off by at most half the
// diagonal of one unit of the velocity code.
TEST_F(SlowCircles, ContourSpeedIsOffByHalfADiagonalOfItsUnitAtMost) {
  double worst = 0.0;
  visit([&](const CodedCircle& circle, int n) {
    const auto vx = static_cast<double>(velocity_code(circle.x(n - 1), circle.x(n), circle.scale));
    const auto vy = static_cast<double>(velocity_code(circle.y(n - 1), circle.y(n), circle.scale));
    const double chord = 2.0 * circle.radius * std::sin(0.5 * circle.step / circle.radius);
    const double wanted = chord / circle.scale.resolution * circle.scale.kmv;
    worst = std::max(worst, std::abs(std::hypot(vx, vy) - wanted));
  });
  EXPECT_LE(worst, std::numbers::sqrt2 / 2.0 + 1e-4);
  EXPECT_GT(worst, 0.65);
}

// Eqs. (10), (13) and (14) project the arc of a cycle on the direction at its middle. The mean
// velocity is its chord, shorter by the share dphi^2 / 24, and points the same way.
TEST(AxisCodes, VelocityIsThatOfThePaperLessTheSagOfTheArc) {
  const CodeScale scale{.resolution = 0.001, .kmv = 1e6};
  const CodedCircle circle{
      .radius = 2.0, .step = 0.2, .start_angle = 0.3, .scale = scale};  // F12000
  const double turn = circle.step / circle.radius;
  for (int n = 1; n < 60; ++n) {
    const double middle = circle.start_angle + (n - 0.5) * turn;
    const double arc = -circle.step / scale.resolution * scale.kmv * std::sin(middle);
    const double sag = turn * turn / 24.0;
    const double next_order = std::abs(arc) * turn * turn * turn * turn / 1920.0;
    EXPECT_NEAR(static_cast<double>(velocity_code(circle.x(n - 1), circle.x(n), scale)),
                arc * (1.0 - sag), 0.5 + 1.01 * next_order);
  }
}

// Figure 3 of the paper: 10 mm/min at 1 kHz and 1000 increments per mm is 1/6 of an increment in a
// cycle; its increments are 0 and 1.
TEST(AxisCodes, IncrementsOfPositionAreOffBy500PercentAtTenMillimetresPerMinute) {
  const CodeScale scale;
  const double feed = 10.0 / 60.0;  // mm/s
  double fastest = 0.0;
  double slowest = 1.0;
  double velocity_error = 0.0;
  for (int n = 1; n <= 6000; ++n) {
    const double before = feed * cycle_s * (n - 1);
    const double now = feed * cycle_s * n;
    const auto increment =
        static_cast<double>(position_code(now, scale) - position_code(before, scale));
    const double wanted = feed * cycle_s / scale.resolution;
    fastest = std::max(fastest, increment / wanted - 1.0);
    slowest = std::min(slowest, increment / wanted - 1.0);
    const auto velocity = static_cast<double>(velocity_code(before, now, scale)) / scale.kmv;
    velocity_error = std::max(velocity_error, std::abs(velocity / wanted - 1.0));
  }
  EXPECT_NEAR(fastest, 5.0, 1e-9);
  EXPECT_NEAR(slowest, -1.0, 1e-9);
  // Eq. (15) for one axis, rounded to nearest: 0.5 / (10000 / 6).
  EXPECT_LE(velocity_error, 3e-4 + 1e-9);
}

// The whole run of a slow arc, ramps and the step into the end included.
TEST(AxisCodes, EveryCycleOfAPathSlowerThanAnIncrementIsCodedWithinHalfAUnit) {
  const Limits limits;
  ChainMaker chain(limits);
  chain.arc(0.3, 1.7 * std::numbers::pi, 0.4).end_chain();
  const auto samples = run_path(three_axes(limits), chain.built());
  const CodeScale scale{.resolution = 0.001, .kmv = 1e5};
  ASSERT_GT(samples.size(), 3000U);
  double travelled = 0.0;
  for (std::size_t n = 1; n < samples.size(); ++n) {
    const double before = samples[n - 1].out.axes[0].value;
    const double now = samples[n].out.axes[0].value;
    ASSERT_LE(std::abs(static_cast<double>(position_code(now, scale)) - now / 0.001), 0.5 + 1e-9);
    travelled += static_cast<double>(velocity_code(before, now, scale)) / scale.kmv;
  }
  const double whole = samples.back().out.axes[0].value - samples.front().out.axes[0].value;
  EXPECT_NEAR(travelled, whole / 0.001, 0.5 / scale.kmv * static_cast<double>(samples.size()));
}

}  // namespace
}  // namespace stanok::motion::testing
