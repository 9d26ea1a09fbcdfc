// What the drives of a channel's axes are told, without a channel around them.
#include "channels/axes/axis_group.h"

#include <gtest/gtest.h>

#include "tests/support/machine/channel_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

constexpr lang::AxisSet only_x = 1U << bench_x;
constexpr lang::AxisSet only_y = 1U << bench_y;

class AxisGroupTest : public ::testing::Test {
 protected:
  ChannelConstants constants_ = bench_constants();
  AxisGroup axes_{constants_};
};

TEST_F(AxisGroupTest, BeginsAtTheStartWithoutPower) {
  EXPECT_EQ(axes_.setpoint(bench_x).position, 10.0);
  EXPECT_EQ(axes_.setpoint(bench_y).position_code, 20000);  // 20 mm in steps of 0.001 mm
  EXPECT_EQ(axes_.enabled(), 0);
  EXPECT_TRUE(axes_.drive(bench_x).brake_closed);
  EXPECT_TRUE(axes_.is_spindle(bench_c));
}

TEST_F(AxisGroupTest, FindsAxesByNameAndByMachineAxis) {
  EXPECT_EQ(axes_.named("Y"), bench_y);
  EXPECT_EQ(axes_.named("Z"), -1);
  EXPECT_EQ(axes_.of_machine_axis(0), bench_y);
  EXPECT_EQ(axes_.of_machine_axis(7), -1);
}

TEST_F(AxisGroupTest, GivesPowerToTheFreeAxesAndBrakesTheOthers) {
  axes_.power(only_x);
  EXPECT_TRUE(axes_.drive(bench_x).enabled);
  EXPECT_FALSE(axes_.drive(bench_x).brake_closed);
  EXPECT_FALSE(axes_.drive(bench_y).enabled);
  EXPECT_TRUE(axes_.drive(bench_y).brake_closed);
}

TEST_F(AxisGroupTest, LeavesAxesOfOtherChannelsAsTheyAre) {
  axes_.release(only_y);
  axes_.set_owned(bench_y, false);
  axes_.power(0);
  EXPECT_TRUE(axes_.drive(bench_y).enabled);
  axes_.brake(only_y);
  EXPECT_TRUE(axes_.drive(bench_y).enabled);
}

TEST_F(AxisGroupTest, HandsAnAxisOverWithItsPositionAndItsDrive) {
  axes_.release(only_x);
  axes_.place(bench_x, 33.5);
  const YieldedAxis yielded = axes_.yield(bench_x);
  EXPECT_FALSE(axes_.owns(bench_x));
  axes_.place(bench_x, 0.0);
  axes_.take(bench_x, yielded);
  EXPECT_TRUE(axes_.owns(bench_x));
  EXPECT_EQ(axes_.setpoint(bench_x).position, 33.5);
  EXPECT_EQ(axes_.setpoint(bench_x).position_code, 33500);
  EXPECT_TRUE(axes_.drive(bench_x).enabled);
}

// 2 mm/s for a cycle of 1 ms is 2 increments of 0.001 mm; the velocity code counts 1/10000 of one.
TEST_F(AxisGroupTest, FollowsThePathWithPositionAndVelocityCodes) {
  motion::JetPoint point{};
  point[bench_x] = {10.002, 2.0, 3.0, 4.0};
  point[bench_y] = 20.0;
  {
    const NoAllocation guard;
    axes_.follow(point);
  }
  const AxisSetpoint& setpoint = axes_.setpoint(bench_x);
  EXPECT_EQ(setpoint.position_code, 10002);
  EXPECT_EQ(setpoint.velocity_code, 20000);
  EXPECT_EQ(setpoint.velocity, 2.0);
  EXPECT_EQ(setpoint.acceleration, 3.0);
  EXPECT_EQ(setpoint.jerk, 4.0);
  EXPECT_EQ(axes_.setpoint(bench_y).velocity_code, 0);
}

// 60 rev/min are 360 deg/s, reached from 0 within a cycle of 1 ms: 360,000 deg/s^2.
TEST_F(AxisGroupTest, ASpindleGivesItsAxisAngleAndSpeed) {
  SpindleConfig config;
  config.speed_max = 6000.0;
  Spindle spindle(config);
  lang::SpindleCommand command;
  command.action = lang::SpindleAction::clockwise;
  command.speed_rev_per_min = 60.0;
  spindle.command(command);
  spindle.advance(bench_cycle_s);
  axes_.turn(bench_c, spindle, 0.0);
  EXPECT_DOUBLE_EQ(axes_.setpoint(bench_c).velocity, 360.0);
  EXPECT_DOUBLE_EQ(axes_.setpoint(bench_c).acceleration, 360.0 / bench_cycle_s);
  EXPECT_EQ(axes_.setpoint(bench_c).velocity_demand, axes_.setpoint(bench_c).velocity);
}

TEST_F(AxisGroupTest, AnAxisIsASpindleUntilItBecomesAnAxis) {
  ChannelOutput output;
  axes_.show(output);
  EXPECT_TRUE(output.drives[bench_c].follows_velocity);
  axes_.become_axis(bench_c, 90.0);
  axes_.show(output);
  EXPECT_FALSE(output.drives[bench_c].follows_velocity);
  EXPECT_EQ(output.axes[bench_c].position, 90.0);
}

}  // namespace
}  // namespace stanok::channels
