// Velocities that drives are asked for, with the loop in the drive and in the cycle.
#include "channels/axes/position_loops.h"

#include <gtest/gtest.h>

#include "tests/support/machine/channel_bench.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

// X closes its loop in the drive, Y in the cycle with kp 30 /s and no feed forward.
ChannelConstants loop_of_y_in_the_cycle() {
  ChannelConstants constants = bench_constants();
  constants.axes[bench_y].controller = {.feedback = FeedbackPlace::cycle,
                                        .gains = {.kp = 30.0, .kv = 0.0}};
  return constants;
}

class PositionLoopsTest : public ::testing::Test {
 protected:
  PositionLoopsTest() { axes_.power(axes_.all()); }

  double demand_of_y() {
    static_cast<void>(drives_.advance(feedback_, LimitSwitches::stop_the_axis));
    loops_.advance(point_, drives_, axes_);
    return axes_.setpoint(bench_y).velocity_demand;
  }

  ChannelConstants constants_ = loop_of_y_in_the_cycle();
  AxisGroup axes_{constants_};
  DriveGuard drives_{constants_, axes_};
  PositionLoops loops_{constants_};
  std::vector<AxisFeedback> feedback_ = bench_feedback(10.0, 20.0, 0.0);
  motion::JetPoint point_{};
};

TEST_F(PositionLoopsTest, ADriveWithItsOwnLoopIsToldTheVelocityOfTheSetpoint) {
  point_[bench_x] = {10.0, 7.5, 0.0, 0.0};
  axes_.follow(point_);
  loops_.advance(point_, drives_, axes_);
  EXPECT_EQ(axes_.setpoint(bench_x).velocity_demand, 7.5);
}

// U = kp e: 0.2 mm behind makes 30 / s * 0.2 mm = 6 mm/s.
TEST_F(PositionLoopsTest, ALoopInTheCycleAsksForWhatTheFollowingErrorMakes) {
  of_axis(feedback_, bench_y).setpoint = 20.2;
  EXPECT_NEAR(demand_of_y(), 6.0, 1e-12);
}

TEST_F(PositionLoopsTest, AnAxisThatItsDriveDoesNotHoldIsAskedForNothing) {
  of_axis(feedback_, bench_y).setpoint = 20.2;
  of_axis(feedback_, bench_y).enabled = false;
  EXPECT_EQ(demand_of_y(), 0.0);
}

}  // namespace
}  // namespace stanok::channels
