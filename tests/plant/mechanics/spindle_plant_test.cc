// Ramp, angle and power of the simulated spindle against closed forms.
#include "plant/mechanics/spindle_plant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stanok::plant {
namespace {

constexpr SpindlePlantConfig main_spindle{.speed_max = 6000.0,
                                          .acceleration = 3000.0,
                                          .coasting_time_s = 2.0,
                                          .power_idle_w = 400.0,
                                          .acceleration_w = 5000.0};

TEST(SpindlePlant, ReachesItsSpeedOnTheRamp) {
  SpindlePlant spindle(main_spindle);
  for (int i = 0; i < 500; ++i) {
    spindle.follow({.velocity = 1500.0}, 1e-3);
  }
  EXPECT_NEAR(spindle.motion().velocity, 1500.0, 1e-9);  // 3000 rev/min/s for 0.5 s
  // Mean 750 rev/min for 0.5 s: 6.25 turns.
  EXPECT_NEAR(spindle.motion().position, 90.0, 1e-6);
}

TEST(SpindlePlant, TurnsBothWaysAndCountsTheAngleWithinOneTurn) {
  SpindlePlant spindle({.speed_max = 6000.0, .acceleration = 0.0});
  for (int i = 0; i < 1000; ++i) {
    spindle.follow({.velocity = -100.0}, 1e-3);
    ASSERT_GE(spindle.motion().position, 0.0);
    ASSERT_LT(spindle.motion().position, 360.0);
  }
  EXPECT_EQ(spindle.motion().velocity, -100.0);
}

TEST(SpindlePlant, StaysWithinItsGreatestSpeed) {
  SpindlePlant spindle(main_spindle);
  for (int i = 0; i < 4000; ++i) {
    spindle.follow({.velocity = 9000.0}, 1e-3);
  }
  EXPECT_EQ(spindle.motion().velocity, 6000.0);
}

TEST(SpindlePlant, IdlePowerIsHalfCoulombHalfViscous) {
  SpindlePlant spindle(main_spindle);
  for (int i = 0; i < 2000; ++i) {
    spindle.follow({.velocity = 3000.0}, 1e-3);
  }
  EXPECT_NEAR(spindle.power_w(), 400.0 * 0.5 * (0.5 + 0.25), 1e-9);
}

TEST(SpindlePlant, AcceleratingTakesPowerAndBrakingGivesItBack) {
  SpindlePlant spindle(main_spindle);
  for (int i = 0; i < 1000; ++i) {
    spindle.follow({.velocity = 6000.0}, 1e-3);
  }
  const double idle = 400.0 * 0.5 * (0.5 + 0.25);  // at 3000 of 6000 rev/min
  EXPECT_NEAR(spindle.power_w(), idle + 5000.0 * 0.5, 1e-6);
  spindle.follow({.velocity = 0.0}, 1e-9);
  EXPECT_NEAR(spindle.power_w(), idle - 5000.0 * 0.5, 1e-3);
}

TEST(SpindlePlant, CoastsExponentially) {
  SpindlePlant spindle({.speed_max = 6000.0, .acceleration = 0.0, .coasting_time_s = 2.0});
  spindle.follow({.velocity = 1000.0}, 1e-3);
  for (int i = 0; i < 2000; ++i) {
    spindle.coast(1e-3);
  }
  EXPECT_NEAR(spindle.motion().velocity, 1000.0 * std::exp(-1.0), 1e-6);
}

}  // namespace
}  // namespace stanok::plant
