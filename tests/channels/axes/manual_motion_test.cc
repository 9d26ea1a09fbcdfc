// Jogs of a single axis by their travel: from inside, and from outside of it.
#include "channels/axes/manual_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stanok::channels {
namespace {

class JogFrom : public ::testing::Test {
 protected:
  JogFrom() {
    ManualAxis axis;
    axis.limits = {.position_min = -100.0,
                   .position_max = 100.0,
                   .velocity_max = 200.0,
                   .acceleration_max = 1000.0,
                   .jerk_max = 20000.0};
    manual.set_up({&axis, 1}, 0.001);
    drive.valid = true;
    drive.referenced = true;
  }

  std::string_view jog(double from, double velocity, double increment = 0.0) {
    return manual.jog({.axis = 0, .velocity = velocity, .increment = increment}, from, drive);
  }
  // Where the axis comes to rest.
  double end(double from) {
    std::array<kinematics::Jet, 1> position{from};
    for (int cycle = 0; cycle < 100000 && manual.is_active(); ++cycle)
      manual.advance({&drive, 1}, position);
    return position[0].value;
  }

  ManualMotion manual;
  AxisFeedback drive;
};

TEST_F(JogFrom, OutsideIsFreeInwardsByAnIncrementThatStaysOutside) {
  EXPECT_EQ(jog(-103.0, 10.0, 1.0), "");
  EXPECT_EQ(end(-103.0), -102.0);
  EXPECT_EQ(jog(105.0, -10.0, 1.0), "");
  EXPECT_EQ(end(105.0), 104.0);
}

TEST_F(JogFrom, OutsideIsFreeInwardsByAnIncrementIntoTheTravel) {
  EXPECT_EQ(jog(-103.0, 10.0, 50.0), "");
  EXPECT_EQ(end(-103.0), -53.0);
}

TEST_F(JogFrom, OutsideEndsAtTheOtherEndOfTheTravelAtMost) {
  EXPECT_EQ(jog(-103.0, 10.0, 204.0), "E6053");
  EXPECT_EQ(jog(-103.0, 10.0), "");
}

TEST_F(JogFrom, OutsideIsRefusedOutwards) {
  EXPECT_EQ(jog(-103.0, -10.0, 1.0), "E6053");
  EXPECT_EQ(jog(-103.0, -10.0), "E6053");
  EXPECT_EQ(jog(103.0, 10.0, 1.0), "E6053");
  EXPECT_EQ(jog(103.0, 10.0), "E6053");
}

TEST_F(JogFrom, TheEndOfTheTravelGoesInwardsOnly) {
  EXPECT_EQ(jog(100.0, 10.0), "E6053");
  EXPECT_EQ(jog(100.0, -10.0, 5.0), "");
  EXPECT_EQ(end(100.0), 95.0);
}

// The clicks of a handwheel: however fast they come, the axis ends where they add up to.
TEST_F(JogFrom, IncrementsAddUp) {
  EXPECT_EQ(jog(0.0, 10.0, 0.1), "");
  for (int n = 0; n < 4; ++n) EXPECT_EQ(jog(0.0, 10.0, 0.1), "");
  EXPECT_EQ(end(0.0), 0.1 + 0.4);
  EXPECT_EQ(jog(0.5, 10.0, 3.0), "");
  EXPECT_EQ(jog(0.5, -10.0, 5.0), "");
  EXPECT_EQ(jog(0.5, -10.0, 1.0), "");
  EXPECT_NEAR(end(0.5), -2.5, 1e-12);
}

TEST_F(JogFrom, IncrementsAddUpToTheEndOfTheTravel) {
  EXPECT_EQ(jog(90.0, 10.0, 6.0), "");
  EXPECT_EQ(jog(90.0, 10.0, 4.0), "");
  EXPECT_EQ(jog(90.0, 10.0, 0.001), "E6053");
  EXPECT_EQ(end(90.0), 100.0);
}

// Nothing is left of them.
TEST_F(JogFrom, AStopEndsAllIncrements) {
  EXPECT_EQ(jog(0.0, 10.0, 5.0), "");
  EXPECT_EQ(jog(0.0, 10.0, 5.0), "");
  manual.stop();
  EXPECT_LT(end(0.0), 1.0);
  EXPECT_EQ(jog(0.0, 10.0, 5.0), "");
}

// With the other direction, or while it is renewed, a jog is another one.
TEST_F(JogFrom, AnIncrementDoesNotJoinAJogThatIsHeld) {
  EXPECT_EQ(jog(0.0, 10.0), "");
  EXPECT_EQ(jog(0.0, 10.0, 1.0), "E6056");
}

// A wheel that is turned by a person: in steps, to and fro, faster than the axis can follow.
class WheelBench {
 protected:
  WheelBench() {
    ManualAxis axis;
    axis.limits = {.position_min = -100.0,
                   .position_max = 100.0,
                   .velocity_max = 50.0,
                   .acceleration_max = 500.0,
                   .jerk_max = 10000.0};
    manual.set_up({&axis, 1}, 0.001);
    drive.valid = true;
    drive.referenced = true;
  }

  void cycle() {
    const kinematics::Jet before = position[0];
    manual.advance({&drive, 1}, position);
    EXPECT_LE(std::abs(position[0].value), 100.0 + 1e-9);
    EXPECT_LE(std::abs(position[0].value - before.value), 50.0 * 0.001 * (1.0 + 1e-9));
    EXPECT_LE(std::abs(position[0].second), 500.0 * (1.0 + 1e-9));
    EXPECT_LE(std::abs(position[0].third), 10000.0 * (1.0 + 1e-9));
  }
  std::string_view turn(double way) { return manual.turn(0, way, position[0].value, drive); }

  ManualMotion manual;
  AxisFeedback drive;
  std::array<kinematics::Jet, 1> position{0.0};
};

class WheelByChance : public WheelBench, public ::testing::TestWithParam<unsigned> {};
class Wheel : public WheelBench, public ::testing::Test {};

// At rest within the tenth of a second that it may be behind, a brake, and what a turn back takes.
TEST_P(WheelByChance, TheAxisStandsSoonAfterIt) {
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const double step = part(random) < 0.5 ? 0.01 : 1.0;
  for (int k = 0; k < 3000; ++k) {
    if (part(random) < 0.1) {
      const std::string_view code = turn(part(random) < 0.7 ? step : -step);
      EXPECT_TRUE(code.empty() || code == "E6053") << code;
    }
    cycle();
  }
  int behind = 0;
  for (; manual.is_active() && behind < 5000; ++behind) cycle();
  EXPECT_LE(behind, 600);
  EXPECT_EQ(position[0].first, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Hands, WheelByChance, ::testing::Range(1U, 41U));

// What it can follow it follows to the step.
TEST_F(Wheel, SlowStepsAddUp) {
  for (int k = 0; k < 200; ++k) {
    EXPECT_EQ(turn(k < 150 ? 0.01 : -0.01), "");
    for (int n = 0; n < 20; ++n) cycle();
  }
  while (manual.is_active()) cycle();
  EXPECT_NEAR(position[0].value, 1.0, 1e-9);
}

TEST_F(Wheel, EndsAtTheEndOfTheTravel) {
  for (int k = 0; k < 200; ++k) {
    const std::string_view code = turn(1.0);
    EXPECT_TRUE(code.empty() || code == "E6053");
    for (int n = 0; n < 20; ++n) cycle();
  }
  while (manual.is_active()) cycle();
  EXPECT_NEAR(position[0].value, 100.0, 1e-9);
  EXPECT_EQ(turn(1.0), "E6053");
  EXPECT_EQ(turn(-1.0), "");
}

}  // namespace
}  // namespace stanok::channels
