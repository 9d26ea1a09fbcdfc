// The velocity-controlled axis against the transfer functions of its two oscillators.
#include "plant/mechanics/servo_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "tests/plant/step_response.h"
#include "tests/support/no_allocation.h"

namespace stanok::plant {
namespace {

constexpr double loop_rad_per_s = 2.0 * std::numbers::pi * 30.0;
constexpr VelocityLoopConfig stiff{.bandwidth_hz = 30.0, .damping = 0.6, .resonance_hz = 0.0};
constexpr VelocityLoopConfig elastic{
    .bandwidth_hz = 30.0, .damping = 0.6, .resonance_hz = 20.0, .resonance_damping = 0.05};

TEST(ServoAxis, StiffAxisHasTheVelocityOfTheTextbookWhateverTheStep) {
  const unsigned seed = 4;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> steps_s(1e-6, 2e-2);
  ServoAxis axis(stiff, {}, 5.0);
  double t = 0.0;
  while (t < 0.5) {
    const double dt = steps_s(random);
    t += dt;
    axis.follow({.velocity = 70.0}, dt);
    ASSERT_NEAR(axis.motion().velocity, 70.0 * step_response(loop_rad_per_s, 0.6, t), 1e-10)
        << "t " << t;
  }
}

TEST(ServoAxis, OneLongStepIsThatOfManyShortOnes) {
  ServoAxis once(elastic, {}, -300.0);
  ServoAxis often(elastic, {}, -300.0);
  for (const double demand : {100.0, -40.0, 0.0}) {
    once.follow({.velocity = demand}, 0.0375);
    for (int n = 0; n < 300; ++n) often.follow({.velocity = demand}, 0.000125);
    EXPECT_NEAR(once.motion().position, often.motion().position, 1e-10);
    EXPECT_NEAR(once.motion().velocity, often.motion().velocity, 1e-9);
    EXPECT_NEAR(once.motion().acceleration, often.motion().acceleration, 1e-6);
  }
}

TEST(ServoAxis, VelocityAndAccelerationAreTheDerivatives) {
  ServoAxis axis(elastic, {}, 0.0);
  for (int n = 0; n < 30; ++n) axis.follow({.velocity = 50.0}, 1e-3);
  const Motion before = axis.motion();
  const double dt = 1e-6;
  axis.follow({.velocity = 50.0}, dt);
  const Motion after = axis.motion();
  // The mean of both ends is exact to dt^2.
  EXPECT_NEAR((after.position - before.position) / dt, 0.5 * (after.velocity + before.velocity),
              1e-6);
  EXPECT_NEAR((after.velocity - before.velocity) / dt,
              0.5 * (after.acceleration + before.acceleration), 1e-4);
}

// Gain from demand to velocity of the load, below, at and above both natural frequencies.
TEST(ServoAxis, AnswersASineAsItsTransferFunctionSays) {
  using Complex = std::complex<double>;
  const double w = loop_rad_per_s;
  const double r = 2.0 * std::numbers::pi * 20.0;
  for (const double hz : {2.0, 15.0, 20.0, 30.0, 60.0}) {
    const double f = 2.0 * std::numbers::pi * hz;
    const Complex s{0.0, f};
    const Complex loop = w * w / (s * s + 2.0 * 0.6 * w * s + w * w);
    const Complex spring = (2.0 * 0.05 * r * s + r * r) / (s * s + 2.0 * 0.05 * r * s + r * r);
    ServoAxis axis(elastic, {}, 0.0);
    const double dt = 1e-5;
    double sine = 0.0;  // parts of the velocity in phase with the demand, and a quarter ahead
    double cosine = 0.0;
    const auto settled = static_cast<int>(2.0 / dt);  // exp(-h r t) = 3e-6
    const auto cycles = static_cast<int>(std::lround(1.0 / dt));
    for (int n = 0; n < settled + cycles; ++n) {
      axis.follow({.velocity = std::sin(f * (n + 0.5) * dt)}, dt);
      if (n < settled) continue;
      const double t = (n + 1) * dt;
      sine += 2.0 * dt * axis.motion().velocity * std::sin(f * t);
      cosine += 2.0 * dt * axis.motion().velocity * std::cos(f * t);
    }
    EXPECT_NEAR(sine, (loop * spring).real(), 1e-4) << hz << " Hz";
    EXPECT_NEAR(cosine, (loop * spring).imag(), 1e-4) << hz << " Hz";
  }
}

// The lag of the velocity loop is 2 d / w; the spring adds none.
TEST(ServoAxis, IsLateByTheLagOfItsVelocityLoop) {
  ServoAxis axis(elastic, {}, 10.0);
  const double v = 80.0;
  for (int n = 0; n < 5000; ++n) axis.follow({.velocity = v}, 1e-3);
  EXPECT_NEAR(axis.motion().position, 10.0 + v * (5.0 - 2.0 * 0.6 / loop_rad_per_s), 1e-8);
  EXPECT_NEAR(axis.motion().velocity, v, 1e-9);
}

TEST(ServoAxis, FollowsNoMoreThanItsHighestVelocity) {
  ServoAxis axis(stiff, {.velocity_max = 50.0}, 0.0);
  for (int n = 0; n < 1000; ++n) axis.follow({.velocity = -400.0}, 1e-3);
  EXPECT_NEAR(axis.motion().velocity, -50.0, 1e-9);
}

TEST(ServoAxis, ComesToRestOnTheQuickStopRampAndStartsAgainFromThere) {
  ServoAxis axis(elastic, {.quick_stop_deceleration = 2000.0}, 0.0);
  for (int n = 0; n < 5000; ++n) axis.follow({.velocity = 100.0}, 1e-3);
  const double start = axis.motion().position;
  for (int n = 0; n < 100; ++n) axis.ramp_down(1e-3);
  EXPECT_EQ(axis.motion().velocity, 0.0);
  EXPECT_NEAR(axis.motion().position - start, 2.5, 1e-6);  // v^2 / 2a
  for (int n = 0; n < 1000; ++n) axis.follow({}, 1e-3);
  EXPECT_NEAR(axis.motion().position - start, 2.5, 1e-6);
}

// A stop that is taken back leaves motor and load at one velocity: nothing swings.
TEST(ServoAxis, GoesOnEvenlyFromAStopThatIsTakenBack) {
  ServoAxis axis(elastic, {.quick_stop_deceleration = 2000.0}, 0.0);
  for (int n = 0; n < 5000; ++n) axis.follow({.velocity = 100.0}, 1e-3);
  for (int n = 0; n < 20; ++n) axis.ramp_down(1e-3);
  EXPECT_NEAR(axis.motion().velocity, 60.0, 1e-6);
  for (int n = 0; n < 200; ++n) {
    axis.follow({.velocity = axis.motion().velocity}, 1e-3);
    ASSERT_NEAR(axis.motion().velocity, 60.0, 1e-6);
  }
}

TEST(ServoAxis, AllocatesNothing) {
  ServoAxis axis(elastic, {}, 0.0);
  const testing::NoAllocation guard;
  axis.follow({.velocity = 1.0}, 1e-3);
  axis.coast(1e-3);
}

}  // namespace
}  // namespace stanok::plant
