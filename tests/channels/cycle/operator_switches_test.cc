// Overrides, optional stop and block skip, and what a program admits of them.
#include "channels/cycle/operator_switches.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

class OperatorSwitchesTest : public ::testing::Test {
 protected:
  stanok::testing::CycleBench bench_;
  OperatorSwitches& switches_ = bench_.parts.switches;
};

TEST_F(OperatorSwitchesTest, AnOverrideActsWhereTheProgramAdmitsIt) {
  switches_.set_feed_override(0.4);
  EXPECT_EQ(switches_.feed_override_in_force(), 0.4);
  lang::OverrideControl exact;
  exact.feed_enabled = false;
  switches_.admit(exact);
  EXPECT_EQ(switches_.feed_override_in_force(), 1.0);
  EXPECT_EQ(switches_.feed_override(), 0.4);
  switches_.admit({});
  EXPECT_EQ(switches_.feed_override_in_force(), 0.4);
}

TEST_F(OperatorSwitchesTest, ASpindleOverrideActsWhereTheProgramAdmitsIt) {
  lang::SpindleCommand command;
  command.action = lang::SpindleAction::clockwise;
  command.speed_rev_per_min = 600.0;
  bench_.parts.spindles.command(command);
  switches_.set_spindle_override(1.5);
  bench_.cycles(30);
  EXPECT_EQ(bench_.parts.spindles.speed(0), 900.0);
  lang::OverrideControl exact;
  exact.spindle_enabled = false;
  switches_.admit(exact);
  bench_.cycles(30);
  EXPECT_EQ(bench_.parts.spindles.speed(0), 600.0);
}

TEST_F(OperatorSwitchesTest, AHoldThatWaitedActsWhenTheProgramAdmitsIt) {
  bench_.begin_run();
  lang::OverrideControl exact;
  exact.feed_stop_enabled = false;
  switches_.admit(exact);
  switches_.hold();
  EXPECT_EQ(bench_.parts.run.state().situation(), Situation::running);
  switches_.admit({});
  EXPECT_EQ(bench_.parts.run.state().situation(), Situation::held);
}

TEST_F(OperatorSwitchesTest, LevelsOfBlockSkipAreIndependent) {
  switches_.set_block_skip(1, true);
  switches_.set_block_skip(9, true);
  EXPECT_EQ(switches_.block_skip(), 1U << 1 | 1U << 9);
  switches_.set_block_skip(1, false);
  EXPECT_EQ(switches_.block_skip(), 1U << 9);
}

}  // namespace
}  // namespace stanok::channels
