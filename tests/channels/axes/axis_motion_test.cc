// The axes of a channel along a path and by hand, without programs.
#include "channels/axes/axis_motion.h"

#include <gtest/gtest.h>

#include "tests/support/machine/motion_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

class AxisMotionTest : public ::testing::Test {
 protected:
  AxisMotionTest() { axes_.power(axes_.all()); }

  std::optional<Fault> cycle() {
    const NoAllocation guard;
    return motion_.advance(bench_.queue, {}, 0, SoftLimits::guarded);
  }
  void take_feedback() {
    static_cast<void>(drives_.advance(feedback_, LimitSwitches::stop_the_axis));
  }

  MotionBench bench_;
  AxisGroup& axes_ = bench_.axes;
  DriveGuard& drives_ = bench_.drives;
  AxisMotion& motion_ = bench_.motion;
  std::vector<AxisFeedback> feedback_ = bench_feedback(10.0, 20.0, 0.0);
};

TEST_F(AxisMotionTest, StandsWhereTheAxesAreAtTheStart) {
  EXPECT_FALSE(cycle());
  EXPECT_TRUE(motion_.is_standing());
  EXPECT_EQ(motion_.path().point[0].value, 10.0);
  EXPECT_EQ(motion_.axes_M()[1], 20.0);
  EXPECT_EQ(diameter_at_tool(motion_), 20.0);  // of X = 10 mm
}

// A step of 1 mm at 50 mm/s ends there, and the path begins anew where the axis has come to.
TEST_F(AxisMotionTest, AJogMovesTheAxisAndThePathGoesOnFromThere) {
  take_feedback();
  ASSERT_EQ(motion_.manual().jog({.axis = bench_x, .velocity = 50.0, .increment = 1.0}, 10.0,
                                 drives_.feedback(bench_x)),
            "");
  EXPECT_FALSE(motion_.is_standing());
  for (int k = 0; k < 2000 && motion_.manual().is_active(); ++k) ASSERT_FALSE(cycle());
  EXPECT_TRUE(motion_.is_standing());
  EXPECT_NEAR(axes_.setpoint(bench_x).position, 11.0, 1e-9);
  ASSERT_FALSE(cycle());
  EXPECT_NEAR(motion_.path().point[0].value, 11.0, 1e-9);
}

TEST_F(AxisMotionTest, AnImpossibleStepLeavesTheAxesWhereTheyWere) {
  ASSERT_FALSE(cycle());
  motion_.stand_with(bench_x, 200.0);
  const auto fault = cycle();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code.view(), "A9002");
  EXPECT_EQ(axes_.setpoint(bench_x).position, 10.0);
  EXPECT_EQ(motion_.axes_M()[0], 10.0);
  EXPECT_FALSE(cycle());
}

TEST_F(AxisMotionTest, ANewFrameIsToldOnce) {
  EXPECT_TRUE(motion_.takes_new_frame());
  EXPECT_FALSE(motion_.takes_new_frame());
  motion_.select_scheme(1);
  EXPECT_EQ(bench_.schemes.active_id(), 1);
  EXPECT_TRUE(motion_.takes_new_frame());
}

TEST_F(AxisMotionTest, APositionIsAdoptedFromADriveThatDoesNotHoldItsAxis) {
  of_axis(feedback_, bench_x) = {.position = 12.5, .valid = true};
  take_feedback();
  motion_.adopt_positions(Power::on);
  EXPECT_EQ(axes_.setpoint(bench_x).position, 12.5);
  EXPECT_EQ(motion_.axes_M()[0], 12.5);
  EXPECT_EQ(axes_.setpoint(bench_y).position, 20.0);
}

// Rounding of the drive is no move: up to two increments of 0.001 mm.
TEST_F(AxisMotionTest, RoundingOfADriveIsNotAdopted) {
  of_axis(feedback_, bench_x) = {.position = 10.0015, .valid = true};
  take_feedback();
  motion_.adopt_positions(Power::on);
  EXPECT_EQ(axes_.setpoint(bench_x).position, 10.0);
}

TEST_F(AxisMotionTest, WhileTheMachineIsOffPositionsOfAllAxesAreAdopted) {
  axes_.power(0);
  of_axis(feedback_, bench_y) = {.position = 25.0, .valid = true};
  take_feedback();
  motion_.adopt_positions(Power::on);
  EXPECT_EQ(axes_.setpoint(bench_y).position, 20.0);
  motion_.adopt_positions(Power::off);
  EXPECT_EQ(axes_.setpoint(bench_y).position, 25.0);
}

TEST_F(AxisMotionTest, AxesAreHomedThatLookForASwitchAndAreMovedByThisChannel) {
  EXPECT_EQ(axes_to_home(axes_), 0);
  bench_.constants.axes[bench_x].manual.homing.order = 1;
  bench_.constants.axes[bench_y].manual.homing.order = 1;
  bench_.constants.axes[bench_c].manual.homing.order = 2;  // a spindle now
  axes_.set_owned(bench_y, false);
  EXPECT_EQ(axes_to_home(axes_), 1U << bench_x);
}

}  // namespace
}  // namespace stanok::channels
