// The last guards before a setpoint reaches a drive.
#include "channels/axes/setpoint_guard.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/machine/channel_bench.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

class SetpointGuardTest : public ::testing::Test {
 protected:
  motion::JetPoint standing() const {
    motion::JetPoint point{};
    for (int axis = 0; axis < axes_.count(); ++axis)
      point[static_cast<std::size_t>(axis)] = axes_.setpoint(axis).position;
    return point;
  }
  std::optional<Fault> step(const motion::JetPoint& point, Steps steps = Steps::of_axes) const {
    return impossible_step(motion_, bench_cycle_s, axes_, point, steps);
  }

  ChannelConstants constants_ = bench_constants();
  motion::MotionConfig motion_ = bench_motion();
  AxisGroup axes_{constants_};
};

// An axis of 100 mm/s moves 0.1 mm in a cycle of 1 ms; twice that and an increment may be
// commanded.
TEST_F(SetpointGuardTest, AStepThatTheAxisCannotMakeIsAFault) {
  motion::JetPoint point = standing();
  point[bench_x].value += 0.2;
  EXPECT_FALSE(step(point));
  point[bench_x].value += 0.002;
  ASSERT_TRUE(step(point));
  EXPECT_EQ(step(point)->code.view(), "A9002");
  EXPECT_EQ(step(point)->text.view(), "axis X would move farther in one cycle than it can");
}

TEST_F(SetpointGuardTest, WhatIsNoNumberIsAFaultInEveryDerivative) {
  for (double kinematics::Jet::* part : {&kinematics::Jet::value, &kinematics::Jet::first,
                                         &kinematics::Jet::second, &kinematics::Jet::third}) {
    motion::JetPoint point = standing();
    point[bench_y].*part = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(step(point, Steps::of_numbers));
  }
}

TEST_F(SetpointGuardTest, NumbersThatHomingGivesAnewAndSpindlesMayStep) {
  motion::JetPoint point = standing();
  point[bench_c].value += 300.0;
  EXPECT_FALSE(step(point));
  point[bench_x].value += 300.0;
  EXPECT_FALSE(step(point, Steps::of_numbers));
}

TEST_F(SetpointGuardTest, AxesOfOtherChannelsAreTheirs) {
  axes_.set_owned(bench_x, false);
  motion::JetPoint point = standing();
  point[bench_x].value += 300.0;
  EXPECT_FALSE(step(point));
}

// From 50 mm/s with 1000 mm/s^2 an axis stands after more than v^2 / 2a = 1.25 mm.
TEST_F(SetpointGuardTest, AnAxisThatCannotStandBeforeItsLimitIsAFault) {
  motion::JetPoint point = standing();
  point[bench_x] = {499.0, 50.0, 0.0, 0.0};
  const auto fault = passed_limit(motion_, bench_cycle_s, axes_, point);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code.view(), "A2003");
  point[bench_x] = {400.0, 50.0, 0.0, 0.0};
  EXPECT_FALSE(passed_limit(motion_, bench_cycle_s, axes_, point));
}

}  // namespace
}  // namespace stanok::channels
