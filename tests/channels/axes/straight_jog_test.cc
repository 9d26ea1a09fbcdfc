// Jogs along a line: no axis beyond its limits or its travel, all of them on the line.
#include "channels/axes/straight_jog.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stanok::channels {
namespace {

constexpr double jog_cycle_s = 0.001;

class StraightJogTest : public ::testing::Test {
 protected:
  StraightJogTest() {
    for (ManualAxis& axis : axes)
      axis.limits = {.position_min = -100.0,
                     .position_max = 100.0,
                     .velocity_max = 200.0,
                     .acceleration_max = 1000.0,
                     .jerk_max = 20000.0};
    axes[1].limits.velocity_max = 50.0;
    axes[1].limits.acceleration_max = 400.0;
    for (AxisFeedback& drive : drives) drive.valid = drive.referenced = true;
  }

  std::string_view begin(double velocity, double increment = 0.0) {
    return jog.begin(line(velocity, increment), axes, drives, positions);
  }
  static JogLine line(double velocity, double increment = 0.0) {
    return {.direction = {{0.6, 0.8, 0.0}}, .velocity = velocity, .increment = increment};
  }
  // To rest, or for so many cycles.
  void run(int cycles = 100000) {
    for (int cycle = 0; cycle < cycles && jog.is_active(); ++cycle) {
      jog.advance(jog_cycle_s, positions);
      for (std::size_t k = 0; k < axes.size(); ++k) {
        const motion::AxisLimits& limits = axes[k].limits;
        share = std::max({share, std::abs(positions[k].first) / limits.velocity_max,
                          std::abs(positions[k].second) / limits.acceleration_max,
                          std::abs(positions[k].third) / limits.jerk_max});
      }
      off = std::max(off, std::abs(0.8 * positions[0].value - 0.6 * positions[1].value));
    }
  }

  std::array<ManualAxis, 3> axes{};
  std::array<AxisFeedback, 3> drives{};
  std::array<kinematics::Jet, 3> positions{};
  StraightJog jog;
  double share = 0.0;  // of the limits
  double off = 0.0;    // the line, mm
};

TEST_F(StraightJogTest, GoesItsIncrement) {
  ASSERT_EQ(begin(20.0, 50.0), "");
  run();
  EXPECT_NEAR(positions[0].value, 30.0, 1e-12);
  EXPECT_NEAR(positions[1].value, 40.0, 1e-12);
  EXPECT_EQ(positions[2].value, 0.0);
  EXPECT_LT(off, 1e-12);
  ASSERT_EQ(begin(-20.0, 50.0), "");
  run();
  EXPECT_NEAR(positions[0].value, 0.0, 1e-12);
}

TEST_F(StraightJogTest, KeepsTheLimitsOfEveryAxis) {
  ASSERT_EQ(begin(1e5), "");
  run();
  EXPECT_LE(share, 1.0 + 1e-12);
  EXPECT_GT(share, 0.99);
}

// Y gets 0.8 mm a millimetre, so it is the first at its end.
TEST_F(StraightJogTest, EndsWhereTheFirstAxisEnds) {
  ASSERT_EQ(begin(100.0), "");
  run();
  EXPECT_NEAR(positions[1].value, 100.0, 1e-12);
  EXPECT_NEAR(positions[0].value, 75.0, 1e-12);
  EXPECT_EQ(begin(100.0), "E6053");
  EXPECT_EQ(begin(-100.0, 251.0), "E6053");
  EXPECT_EQ(begin(-100.0, 249.0), "");
}

TEST_F(StraightJogTest, ComesToRestOnTheLineWhenItsLeaseEnds) {
  ASSERT_EQ(begin(20.0), "");
  jog.lease(100);
  run(50);
  EXPECT_TRUE(jog.renew(line(20.0), 100));
  run(10000);
  EXPECT_FALSE(jog.is_active());
  EXPECT_LT(off, 1e-12);
  // 150 cycles of 20 mm/s at most, and the braking.
  EXPECT_GT(positions[1].value, 1.0);
  EXPECT_LT(positions[1].value, 0.8 * 20.0 * 0.2);
}

TEST_F(StraightJogTest, TheOppositeAndAnotherDirectionDoNotRenewIt) {
  ASSERT_EQ(begin(20.0), "");
  jog.lease(1000);
  run(50);
  JogLine other = line(20.0);
  other.direction = {{1.0, 0.0, 0.0}};
  EXPECT_FALSE(jog.renew(other, 1000));
  EXPECT_FALSE(jog.renew(line(-20.0), 1000));
  run(200);
  EXPECT_FALSE(jog.is_active());
}

TEST_F(StraightJogTest, IsRefusedOnALimitSwitchAndWithoutAReference) {
  drives[0].limit_positive = true;
  EXPECT_EQ(begin(20.0), "E6057");
  EXPECT_EQ(begin(-20.0, 1.0), "");
  run();
  drives[0].limit_positive = false;
  drives[1].referenced = false;
  EXPECT_EQ(begin(20.0), "E6059");
}

}  // namespace
}  // namespace stanok::channels
