// Holds, ends and alarms of a channel, without programs.
#include "channels/cycle/run_control.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using stanok::testing::CycleBench;

class RunControlTest : public ::testing::Test {
 protected:
  Situation situation() const { return run_.state().situation(); }

  CycleBench bench_;
  RunControl& run_ = bench_.parts.run;
};

TEST_F(RunControlTest, AHoldStopsThePathUntilItIsResumed) {
  bench_.begin_run();
  EXPECT_FALSE(run_.holds_path());
  run_.hold(HoldCause::channel_stop);
  EXPECT_TRUE(run_.holds_path());
  EXPECT_FALSE(run_.leaves_thread());
  EXPECT_EQ(run_.hold_cause(), HoldCause::channel_stop);
  run_.resume();
  EXPECT_FALSE(run_.holds_path());
  EXPECT_EQ(run_.hold_cause(), HoldCause::none);
}

TEST_F(RunControlTest, WithoutARunThereIsNothingToHold) {
  run_.hold(HoldCause::operator_hold);
  EXPECT_EQ(situation(), Situation::off);
  EXPECT_FALSE(run_.holds_path());
}

TEST_F(RunControlTest, AHoldThatTheProgramDoesNotAdmitWaits) {
  bench_.begin_run();
  run_.hold_by_operator(FeedStop::waits);
  EXPECT_EQ(situation(), Situation::running);
  EXPECT_TRUE(run_.hold_waits());
  run_.hold_by_operator(FeedStop::acts);
  EXPECT_EQ(situation(), Situation::held);
  EXPECT_FALSE(run_.hold_waits());
}

TEST_F(RunControlTest, AHoldOutsideOfProgramsOvertakesWhatWasAskedForBefore) {
  run_.apply(Change::power_on);
  const std::uint32_t generation = run_.generation();
  run_.hold_by_operator(FeedStop::acts);
  EXPECT_EQ(run_.generation(), generation + 1);
  run_.apply(Change::switch_begins);
  run_.hold_by_operator(FeedStop::acts);
  EXPECT_EQ(situation(), Situation::ending);
}

TEST_F(RunControlTest, AResetAsksThePreparationOnceAndLeavesTheThread) {
  bench_.begin_run();
  run_.begin_reset();
  run_.begin_reset();
  EXPECT_EQ(bench_.link.resets_wanted, 1U);
  EXPECT_TRUE(run_.holds_path());
  EXPECT_TRUE(run_.leaves_thread());
  EXPECT_FALSE(run_.reset_is_told());
  run_.note_reset_told();
  run_.end_run(RunResult::failed, 0);
  run_.finish_reset();
  EXPECT_EQ(situation(), Situation::ready);
  EXPECT_FALSE(run_.holds_path());
  EXPECT_TRUE(bench_.parts.runs.was_reset());
}

TEST_F(RunControlTest, AnAlarmStaysUntilAResetThatBeganBehindIt) {
  bench_.begin_run();
  run_.fail("E6024", "too fast", {});
  run_.fail("E6021", "a second alarm is not told", {});
  EXPECT_EQ(bench_.event(), "E6024");
  EXPECT_EQ(bench_.event(), "none");
  run_.end_run(RunResult::failed, 0);
  run_.finish_reset();
  EXPECT_EQ(situation(), Situation::alarm);
  run_.begin_stop();
  run_.finish_reset();
  EXPECT_EQ(situation(), Situation::alarm);
  run_.begin_reset();
  run_.finish_reset();
  EXPECT_EQ(situation(), Situation::ready);
}

TEST_F(RunControlTest, AFaultTakesPowerOffAtStandstillOnce) {
  bench_.begin_run();
  run_.fault({{"A3001"}, {"the drive of axis X does not answer"}});
  EXPECT_FALSE(run_.takes_power_off());  // it is still ending
  run_.end_run(RunResult::failed, 0);
  run_.finish_reset();
  EXPECT_TRUE(run_.takes_power_off());
  EXPECT_FALSE(run_.takes_power_off());
}

TEST_F(RunControlTest, AnEmergencyStopIsToldEvenInAFault) {
  bench_.begin_run();
  run_.fault({{"A3001"}, {"the drive of axis X does not answer"}});
  EXPECT_EQ(bench_.event(), "A3001");
  run_.stop_in_emergency();
  EXPECT_EQ(bench_.event(), "A1001");
}

TEST_F(RunControlTest, AResumeTakesTheNextStepOnlyBehindAStep) {
  bench_.begin_run();
  run_.stepper().switch_on({.run = 1, .block = 4});
  run_.hold(HoldCause::operator_hold);
  run_.resume();
  EXPECT_FALSE(run_.stepper().awaits_next());
  run_.hold(HoldCause::single_block);
  run_.resume();
  EXPECT_TRUE(run_.stepper().awaits_next());
}

TEST_F(RunControlTest, AllocatesNothing) {
  bench_.begin_run();
  const stanok::testing::NoAllocation guard;
  run_.hold(HoldCause::operator_hold);
  run_.resume();
  run_.fault({{"A3001"}, {"the drive of axis X does not answer"}});
  run_.finish_reset();
}

}  // namespace
}  // namespace stanok::channels
