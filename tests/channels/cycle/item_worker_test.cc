// Items of a program in their order, without a preparation.
#include "channels/cycle/item_worker.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using stanok::testing::CycleBench;

class ItemWorkerTest : public ::testing::Test {
 protected:
  ItemWorkerTest() { bench_.begin_run(); }

  Item& add(ItemKind kind) {
    made_ = item_of(kind, {.run = 1, .block = ++block_, .line = 10});
    return made_;
  }
  void push() { ASSERT_TRUE(bench_.link.items.push(made_)); }
  void cycle() {
    bench_.cycles(1);
    const stanok::testing::NoAllocation guard;
    worker_.advance();
  }
  Situation situation() const { return bench_.parts.run.state().situation(); }

  CycleBench bench_;
  ItemWorker worker_{bench_.parts};
  Item made_;
  std::uint64_t block_ = 0;
};

TEST_F(ItemWorkerTest, ADwellTakesItsCyclesAndKeepsWhatIsBehind) {
  add(ItemKind::dwell).value = 0.003;
  push();
  add(ItemKind::output).number = 2;
  made_.value = 1.0;
  push();
  for (int k = 0; k < 4; ++k) {
    EXPECT_FALSE(bench_.outputs.is_on(2)) << k;
    EXPECT_EQ(worker_.is_waiting(), k > 0);
    cycle();
  }
  EXPECT_TRUE(bench_.outputs.is_on(2));
}

TEST_F(ItemWorkerTest, WhatComesBehindAChunkOrARiderWaitsForIt) {
  add(ItemKind::tool_change).number = 7;
  made_.value = 1.0;
  made_.after_chunk = 1;
  push();
  cycle();
  EXPECT_EQ(worker_.tool().number, 0);
  EXPECT_EQ(worker_.chunk_limit(), 0U);  // nothing is in the queue
}

TEST_F(ItemWorkerTest, ASpindleKeepsTheProgramUntilItHasItsSpeed) {
  add(ItemKind::spindle).spindle.action = lang::SpindleAction::clockwise;
  made_.spindle.speed_rev_per_min = 300.0;  // five cycles
  push();
  add(ItemKind::program_stop).number = static_cast<std::int64_t>(lang::StopKind::program_stop);
  push();
  for (int k = 0; k < 5; ++k) cycle();
  EXPECT_EQ(situation(), Situation::running);
  cycle();
  cycle();
  EXPECT_EQ(situation(), Situation::held);
  EXPECT_EQ(bench_.parts.run.hold_cause(), HoldCause::program_stop);
}

TEST_F(ItemWorkerTest, AnOptionalStopIsOneWhereTheOperatorWantsIt) {
  const auto optional = static_cast<std::int64_t>(lang::StopKind::optional_stop);
  add(ItemKind::program_stop).number = optional;
  push();
  cycle();
  EXPECT_EQ(situation(), Situation::running);
  bench_.parts.switches.set_optional_stop(true);
  push();
  cycle();
  EXPECT_EQ(situation(), Situation::held);
}

TEST_F(ItemWorkerTest, ARequestIsOpenUntilItIsAnswered) {
  add(ItemKind::request).request.kind = lang::RequestKind::sync;
  push();
  cycle();
  ASSERT_NE(worker_.request(), nullptr);
  EXPECT_EQ(worker_.request()->request.kind, lang::RequestKind::sync);
  ChannelAnswer answer;
  answer.value = 42.0;
  worker_.answer(answer);
  EXPECT_EQ(worker_.request(), nullptr);
  EXPECT_TRUE(worker_.is_idle());
  EXPECT_EQ(std::get<RequestAnswer>(bench_.notice()).answer.value, 42.0);
  worker_.answer(answer);  // to nobody
  EXPECT_TRUE(std::holds_alternative<PathReset>(bench_.notice()));
}

TEST_F(ItemWorkerTest, TheEndOfARunEndsWhatItBroughtAbout) {
  lang::OverrideControl exact;
  exact.feed_enabled = false;
  bench_.parts.switches.set_feed_override(0.5);
  bench_.parts.switches.admit(exact);
  add(ItemKind::run_end).number = 12;
  push();
  cycle();
  EXPECT_EQ(situation(), Situation::ready);
  EXPECT_TRUE(bench_.parts.runs.ended_well(1));
  EXPECT_EQ(bench_.parts.switches.feed_override_in_force(), 0.5);
}

TEST_F(ItemWorkerTest, AFailedRunLeavesAnAlarm) {
  add(ItemKind::run_failed).code = FixedText<8>("E3008");
  made_.text = ShortText("division by zero");
  push();
  cycle();
  EXPECT_EQ(situation(), Situation::alarm);
  EXPECT_EQ(bench_.event(), "E3008");
  EXPECT_FALSE(bench_.parts.runs.ended_well(1));
}

TEST_F(ItemWorkerTest, WhereThePreparationBrokeOffTheAxesComeToRestAtOnce) {
  add(ItemKind::dwell).value = 1000.0;
  push();
  cycle();
  EXPECT_EQ(situation(), Situation::running);
  add(ItemKind::broken_off).code = FixedText<8>("A9001");
  push();
  cycle();
  EXPECT_EQ(situation(), Situation::ending);
  EXPECT_EQ(bench_.event(), "A9001");
}

TEST_F(ItemWorkerTest, SingleBlockHoldsBeforeTheNextStatement) {
  bench_.parts.run.stepper().switch_on({.run = 1, .block = 1, .line = 10});
  add(ItemKind::output).number = 1;
  made_.tag.block = 2;
  made_.value = 1.0;
  push();
  cycle();
  EXPECT_FALSE(bench_.outputs.is_on(1));
  EXPECT_EQ(bench_.parts.run.hold_cause(), HoldCause::single_block);
  bench_.parts.run.resume();
  cycle();
  EXPECT_TRUE(bench_.outputs.is_on(1));
}

TEST_F(ItemWorkerTest, AResetDropsItemsUpToItsOwn) {
  add(ItemKind::dwell);
  push();
  EXPECT_FALSE(worker_.drop_until_reset_done());
  add(ItemKind::reset_done);
  push();
  add(ItemKind::load_done);
  push();
  EXPECT_TRUE(worker_.drop_until_reset_done());
  EXPECT_EQ(bench_.link.items.size(), 1U);
}

TEST_F(ItemWorkerTest, AStartSaysWhereTheAxesStandAndWhatIsSkipped) {
  bench_.parts.switches.set_block_skip(2, true);
  bench_.parts.run.end_run(RunResult::succeeded, 0);
  worker_.begin_run(Job::line);
  const auto notice = std::get<LineStart>(bench_.notice());
  EXPECT_EQ(notice.start.run, 2U);
  EXPECT_EQ(notice.start.axes_M[1], 20.0);
  EXPECT_EQ(notice.start.block_skip, 1U << 2);
}

}  // namespace
}  // namespace stanok::channels
