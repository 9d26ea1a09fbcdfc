// The feed axis against the textbook solution of the second-order system.
#include "plant/mechanics/axis_plant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/plant/step_response.h"

namespace stanok::plant {
namespace {

constexpr double bandwidth_hz = 20.0;
constexpr double bandwidth_rad_per_s = 2.0 * std::numbers::pi * bandwidth_hz;

class StepResponse : public ::testing::TestWithParam<double> {};

TEST_P(StepResponse, IsTheAnalyticOneWhateverTheStep) {
  const double damping = GetParam();
  const unsigned seed = 2;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> steps_s(1e-5, 5e-3);
  AxisPlant plant({.bandwidth_hz = bandwidth_hz, .damping = damping}, 5.0);
  double t = 0.0;
  while (t < 0.3) {
    const double dt = steps_s(random);
    t += dt;
    plant.follow({.position = 7.0}, dt);
    // Rounding of some hundred steps.
    ASSERT_NEAR(plant.motion().position, 5.0 + 2.0 * step_response(bandwidth_rad_per_s, damping, t),
                1e-11)
        << "t " << t << ", seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Dampings, StepResponse, ::testing::Values(0.1, 0.5, 0.8, 1.0, 1.7));

TEST(AxisPlant, VelocityAndAccelerationAreTheDerivatives) {
  AxisPlant plant({.bandwidth_hz = bandwidth_hz, .damping = 0.6}, 0.0);
  const double dt = 1e-6;
  const Demand demand{.position = 1.0};
  for (int i = 0; i < 1000; ++i) {
    plant.follow(demand, 1e-5);
  }
  const Motion before = plant.motion();
  plant.follow(demand, dt);
  const Motion after = plant.motion();
  // The mean of both ends is exact to dt^2.
  EXPECT_NEAR((after.position - before.position) / dt, 0.5 * (after.velocity + before.velocity),
              1e-5);
  EXPECT_NEAR((after.velocity - before.velocity) / dt,
              0.5 * (after.acceleration + before.acceleration), 1e-3);
}

// Steady error of a ramp: 2 d (1 - k) v / w behind.
TEST(AxisPlant, FollowsARampWithTheErrorTheFeedForwardLeaves) {
  for (const double k : {0.0, 0.9, 1.0}) {
    AxisPlant plant({.bandwidth_hz = bandwidth_hz, .damping = 0.7, .velocity_feed_forward = k},
                    0.0);
    const double v = 100.0;
    Demand demand{.velocity = v};
    for (int i = 1; i <= 1000; ++i) {
      demand.position = v * i * 1e-3;
      plant.follow(demand, 1e-3);
    }
    EXPECT_NEAR(plant.following_error(demand), 2.0 * 0.7 * (1.0 - k) * v / bandwidth_rad_per_s,
                1e-9)
        << k;
    EXPECT_NEAR(plant.motion().velocity, v, 1e-9);
  }
}

TEST(AxisPlant, ComesToRestOnTheQuickStopRamp) {
  AxisPlant plant({.quick_stop_deceleration = 2000.0}, 0.0);
  for (int i = 1; i <= 1000; ++i) {
    plant.follow({.position = 0.1 * i, .velocity = 100.0}, 1e-3);
  }
  const Motion start = plant.motion();
  double t = 0.0;
  while (plant.motion().velocity != 0.0) {
    plant.ramp_down(0.7e-3);
    t += 0.7e-3;
    ASSERT_LT(t, 1.0);
  }
  // v/a = 50 ms, v^2 / 2a = 2.5 mm.
  EXPECT_NEAR(t, 0.05, 0.7e-3);
  EXPECT_NEAR(plant.motion().position - start.position, 2.5, 1e-6);
}

TEST(AxisPlant, CoastsByVelocityTimesTimeConstant) {
  AxisPlant plant({.coasting_time_s = 0.2}, 0.0);
  for (int i = 1; i <= 1000; ++i) {
    plant.follow({.position = 0.01 * i, .velocity = 10.0}, 1e-3);
  }
  const double start = plant.motion().position;
  for (int i = 0; i < 10000; ++i) {
    plant.coast(1e-3);
  }
  EXPECT_NEAR(plant.motion().position - start, 10.0 * 0.2, 1e-6);
}

TEST(AxisPlant, NeverExceedsItsVelocityLimit) {
  AxisPlant plant({.velocity_max = 50.0}, 0.0);
  double before = 0.0;
  for (int i = 0; i < 5000; ++i) {
    plant.follow({.position = 100.0}, 1e-3);
    ASSERT_LE(std::fabs(plant.motion().velocity), 50.0);
    ASSERT_LE(std::fabs(plant.motion().position - before), 50.0e-3 + 1e-12);
    before = plant.motion().position;
  }
  EXPECT_NEAR(before, 100.0, 1e-6);
}

// Dry friction f moves the steady error against the motion by f / w^2, and holds within it at rest.
TEST(AxisPlant, DryFrictionLeavesTheErrorOfAStaticFriction) {
  const double friction = 500.0;
  const double loop = 2.0 * std::numbers::pi * 40.0;
  AxisPlant plant({.bandwidth_hz = 40.0, .dry_friction = friction}, 0.0);
  double target = 0.0;
  for (int i = 0; i < 2000; ++i) {
    target += 10.0 * 1e-3;
    plant.follow({.position = target, .velocity = 10.0}, 1e-3);
  }
  EXPECT_NEAR(target - plant.motion().position, friction / (loop * loop), 1e-9);
  for (int i = 0; i < 1000; ++i) plant.follow({.position = target}, 1e-3);
  EXPECT_EQ(plant.motion().velocity, 0.0);
  EXPECT_LE(std::fabs(target - plant.motion().position), friction / (loop * loop));
  const double rest = plant.motion().position;
  plant.follow({.position = rest + 0.5 * friction / (loop * loop)}, 1e-3);
  EXPECT_EQ(plant.motion().position, rest);
  for (int i = 0; i < 1000; ++i) plant.follow({.position = rest + 0.1}, 1e-3);
  EXPECT_GT(plant.motion().position, rest + 0.08);
}

}  // namespace
}  // namespace stanok::plant
