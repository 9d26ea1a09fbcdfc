// The spindles of a channel, without programs.
#include "channels/axes/spindle_group.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/machine/motion_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

lang::SpindleCommand clockwise(double rev_per_min, int spindle = 0) {
  lang::SpindleCommand command;
  command.spindle = spindle;
  command.action = lang::SpindleAction::clockwise;
  command.speed_rev_per_min = rev_per_min;
  return command;
}

// Spindle 1 is the master and becomes C; spindle 5 becomes no axis. Both take 60 rev/min a cycle.
ChannelConstants two_spindles() {
  ChannelConstants constants = bench_constants();
  constants.spindles[1] = constants.spindles[0];
  constants.spindles[1].id = 5;
  constants.spindle_count = 2;
  return constants;
}

class SpindleGroupTest : public ::testing::Test {
 protected:
  void cycle() {
    const NoAllocation guard;
    spindles_.observe();
    static_cast<void>(motion_.advance(bench_.queue, {}, 0, SoftLimits::not_guarded));
    spindles_.follow_process();
    spindles_.turn();
  }
  void cycles(int count) {
    for (int k = 0; k < count; ++k) cycle();
  }

  MotionBench bench_{two_spindles()};
  AxisGroup& axes_ = bench_.axes;
  DriveGuard& drives_ = bench_.drives;
  AxisMotion& motion_ = bench_.motion;
  SpindleGroup spindles_{bench_.constants, axes_, drives_, motion_};
};

TEST_F(SpindleGroupTest, ZeroMeansTheMasterAndANegativeNumberAll) {
  spindles_.command(clockwise(600.0));
  cycles(20);
  EXPECT_EQ(spindles_.speed(0), 600.0);
  EXPECT_EQ(spindles_.speed(1), 600.0);
  EXPECT_EQ(spindles_.speed(5), 0.0);
  spindles_.command(clockwise(300.0, -1));
  cycles(20);
  EXPECT_EQ(spindles_.speed(5), 300.0);
  EXPECT_EQ(spindles_.speed(9), std::nullopt);
}

TEST_F(SpindleGroupTest, IsSettledWhenEverySpindleHasItsSpeed) {
  EXPECT_TRUE(spindles_.are_settled());
  spindles_.command(clockwise(600.0));
  EXPECT_FALSE(spindles_.are_settled());
  cycles(10);  // 600 rev/min at 60 rev/min a cycle
  EXPECT_TRUE(spindles_.are_settled());
}

TEST_F(SpindleGroupTest, AnOverrideScalesAllSpeeds) {
  spindles_.set_override(0.5);
  spindles_.command(clockwise(600.0, -1));
  cycles(20);
  EXPECT_EQ(spindles_.speed(1), 300.0);
  EXPECT_EQ(spindles_.speed(5), 300.0);
}

// n = v / (pi D): 62.83 m/min at a diameter of 20 mm (X stands at 10) are 1000 rev/min.
TEST_F(SpindleGroupTest, ACuttingSpeedFollowsTheDiameter) {
  cycle();
  spindles_.command(clockwise(100.0));
  spindles_.command(lang::CuttingSpeedMode{.constant = true,
                                           .speed_m_per_min = std::numbers::pi * 0.020 * 1000.0});
  cycles(30);
  EXPECT_NEAR(*spindles_.speed(0), 1000.0, 1e-9);
}

TEST_F(SpindleGroupTest, BecomesAnAxisWhereItStandsAndASpindleAgain) {
  spindles_.command(clockwise(600.0));
  cycles(15);
  spindles_.stop(1);
  cycles(15);
  ASSERT_TRUE(spindles_.stands(1));
  const double angle = spindles_.master().angle_deg();
  EXPECT_GT(angle, 0.0);
  spindles_.close_position_loop(1);
  EXPECT_FALSE(axes_.is_spindle(bench_c));
  EXPECT_EQ(axes_.setpoint(bench_c).position, angle);
  EXPECT_EQ(motion_.axes_M()[bench_c], angle);
  EXPECT_FALSE(spindles_.position_loop_is_closed(1));  // its drive is off
  axes_.power(axes_.all());
  EXPECT_TRUE(spindles_.position_loop_is_closed(1));
  spindles_.open_position_loops();
  EXPECT_TRUE(axes_.is_spindle(bench_c));
}

TEST_F(SpindleGroupTest, ASpindleWithoutAnAxisHasNoLoopToClose) {
  EXPECT_EQ(spindles_.axis_of(1), bench_c);
  EXPECT_EQ(spindles_.axis_of(5), -1);
  EXPECT_FALSE(spindles_.position_loop_is_closed(5));
}

// A tap asks for the way back, twice as fast: 300 rev/min against its direction are -600.
TEST_F(SpindleGroupTest, ObeysATapUntilItGoesOn) {
  spindles_.command(clockwise(300.0));
  cycles(20);
  motion::SpindleOrder order;
  order.kind = motion::SpindleOrder::Kind::turn_back;
  order.factor = 2.0;
  order.acceleration = 1000.0;
  spindles_.obey(order);
  cycles(40);
  EXPECT_EQ(spindles_.speed(1), -600.0);
  order.kind = motion::SpindleOrder::Kind::go_on;
  spindles_.obey(order);
  cycles(40);
  EXPECT_EQ(spindles_.speed(1), 300.0);
}

TEST_F(SpindleGroupTest, ShowsSpeedsFeedPerRevolutionAndCuttingSpeed) {
  cycle();
  spindles_.command(clockwise(500.0));
  cycles(20);
  ProcessOutput output;
  output.feed_mm_per_min = 100.0;
  spindles_.show(output);
  EXPECT_EQ(output.spindle_rev_per_min, 500.0);
  EXPECT_DOUBLE_EQ(output.feed_mm_per_rev, 0.2);
  EXPECT_NEAR(output.cutting_speed_m_per_min, std::numbers::pi * 20.0 * 500.0 / 1000.0, 1e-9);
  EXPECT_EQ(output.spindles[1].id, 5);
}

}  // namespace
}  // namespace stanok::channels
