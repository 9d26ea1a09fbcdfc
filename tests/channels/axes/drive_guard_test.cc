// What drives tell and what of it is a fault, without a channel around them.
#include "channels/axes/drive_guard.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/support/machine/channel_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

class DriveGuardTest : public ::testing::Test {
 protected:
  DriveGuardTest() { axes_.power(axes_.all()); }

  std::optional<Fault> cycle(LimitSwitches switches = LimitSwitches::stop_the_axis) {
    const NoAllocation guard;
    return drives_.advance(feedback_, switches);
  }
  AxisFeedback& drive(int axis) { return of_axis(feedback_, axis); }

  ChannelConstants constants_ = bench_constants();
  AxisGroup axes_{constants_};
  DriveGuard drives_{constants_, axes_};
  std::vector<AxisFeedback> feedback_ = bench_feedback(10.0, 20.0, 0.0);
};

TEST_F(DriveGuardTest, WithoutFeedbackDrivesAreIdeal) {
  EXPECT_FALSE(drives_.advance({}, LimitSwitches::stop_the_axis));
  EXPECT_TRUE(drives_.is_ideal());
  EXPECT_TRUE(drives_.all_ready());
  EXPECT_TRUE(drives_.is_homed(bench_x));
}

TEST_F(DriveGuardTest, TakesEachAxisFromItsPlaceInTheMachine) {
  EXPECT_FALSE(cycle());
  EXPECT_EQ(drives_.feedback(bench_x).position, 10.0);
  EXPECT_EQ(drives_.feedback(bench_y).position, 20.0);
  EXPECT_FALSE(drives_.is_ideal());
}

TEST_F(DriveGuardTest, ADriveThatNeverHeldItsAxisIsNoFault) {
  drive(bench_x) = {};
  EXPECT_FALSE(cycle());
  EXPECT_FALSE(drives_.all_answer());
  EXPECT_FALSE(drives_.all_ready());
}

struct Failing {
  std::string code;
  std::function<void(AxisFeedback&)> fails;
};

TEST_F(DriveGuardTest, ADriveThatHeldItsAxisAndFailsIsAFaultThatNamesIt) {
  const std::vector<Failing> all = {
      {"A3001", [](AxisFeedback& drive) { drive.valid = false; }},
      {"A3001",
       [](AxisFeedback& drive) { drive.position = std::numeric_limits<double>::quiet_NaN(); }},
      {"A3002", [](AxisFeedback& drive) { drive.fault = true; }},
      {"A3003", [](AxisFeedback& drive) { drive.strays = true; }},
      {"A3004", [](AxisFeedback& drive) { drive.enabled = false; }},
  };
  for (const Failing& failing : all) {
    SCOPED_TRACE(failing.code);
    feedback_ = bench_feedback(10.0, 20.0, 0.0);
    ASSERT_FALSE(cycle());
    failing.fails(drive(bench_y));
    const auto fault = cycle();
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->code.view(), failing.code);
    EXPECT_NE(std::string(fault->text.view()).find("axis Y"), std::string::npos);
  }
}

TEST_F(DriveGuardTest, OfSeveralFaultsTheOneThatSaysLeastOfTheAxisComesFirst) {
  ASSERT_FALSE(cycle());
  drive(bench_x).fault = true;
  drive(bench_y).valid = false;
  EXPECT_EQ(cycle()->code.view(), "A3001");
}

TEST_F(DriveGuardTest, AxesThatAreOffOrOfOthersDoNotFail) {
  ASSERT_FALSE(cycle());
  axes_.brake(1U << bench_x);
  axes_.set_owned(bench_y, false);
  drive(bench_x).valid = false;
  drive(bench_y).valid = false;
  EXPECT_FALSE(cycle());
}

TEST_F(DriveGuardTest, AnAxisThatWasTakenOverIsWaitedForAnew) {
  ASSERT_FALSE(cycle());
  drives_.forget(bench_x);
  drive(bench_x).enabled = false;
  EXPECT_FALSE(cycle());
}

TEST_F(DriveGuardTest, ComingOntoALimitSwitchIsAFaultOnce) {
  ASSERT_FALSE(cycle());
  drive(bench_x).limit_negative = true;
  const auto fault = cycle();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code.view(), "A2002");
  EXPECT_EQ(drives_.axis_on_limit_switch(), bench_x);
  EXPECT_FALSE(cycle());
  drive(bench_x).limit_negative = false;
  EXPECT_FALSE(cycle());
  EXPECT_EQ(drives_.axis_on_limit_switch(), -1);
}

TEST_F(DriveGuardTest, HomingLooksForItsSwitchesItself) {
  ASSERT_FALSE(cycle());
  drive(bench_x).limit_positive = true;
  EXPECT_FALSE(cycle(LimitSwitches::are_looked_for));
  EXPECT_EQ(drives_.axis_on_limit_switch(), bench_x);
}

TEST_F(DriveGuardTest, PowerAndReferenceHoldOnlyWhileTheAnswerIsValid) {
  drive(bench_x).valid = false;
  static_cast<void>(cycle());
  EXPECT_FALSE(drives_.feedback(bench_x).enabled);
  EXPECT_FALSE(drives_.is_homed(bench_x));
}

}  // namespace
}  // namespace stanok::channels
