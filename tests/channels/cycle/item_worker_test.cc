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

  Item item(const ItemContent& content) {
    return {.tag = {.run = 1, .block = ++block_, .line = 10}, .content = content};
  }
  void push(const Item& item) { ASSERT_TRUE(bench_.link.items.push(item)); }
  void push(const ItemContent& content) { push(item(content)); }
  void cycle() {
    bench_.cycles(1);
    const stanok::testing::NoAllocation guard;
    worker_.advance();
  }
  Situation situation() const { return bench_.parts.run.state().situation(); }

  CycleBench bench_;
  ItemWorker worker_{bench_.parts};
  std::uint64_t block_ = 0;
};

TEST_F(ItemWorkerTest, ADwellTakesItsCyclesAndKeepsWhatIsBehind) {
  push(lang::Dwell{.seconds = 0.003});
  push(lang::OutputCommand{.number = 2, .value = 1.0});
  for (int k = 0; k < 4; ++k) {
    EXPECT_FALSE(bench_.outputs.is_on(2)) << k;
    EXPECT_EQ(worker_.is_waiting(), k > 0);
    cycle();
  }
  EXPECT_TRUE(bench_.outputs.is_on(2));
}

TEST_F(ItemWorkerTest, WhatComesBehindAChunkOrARiderWaitsForIt) {
  Item change = item(lang::ToolChange{.tool = 7});
  change.after_chunk = 1;
  push(change);
  cycle();
  EXPECT_EQ(worker_.tool().number, 0);
  EXPECT_EQ(worker_.chunk_limit(), 0U);  // nothing is in the queue
}

TEST_F(ItemWorkerTest, ASpindleKeepsTheProgramUntilItHasItsSpeed) {
  push(lang::SpindleCommand{.action = lang::SpindleAction::clockwise,
                            .speed_rev_per_min = 300.0});  // five cycles
  push(lang::ProgramStop{lang::StopKind::program_stop});
  for (int k = 0; k < 5; ++k) cycle();
  EXPECT_EQ(situation(), Situation::running);
  cycle();
  cycle();
  EXPECT_EQ(situation(), Situation::held);
  EXPECT_EQ(bench_.parts.run.hold_cause(), HoldCause::program_stop);
}

TEST_F(ItemWorkerTest, AnOptionalStopIsOneWhereTheOperatorWantsIt) {
  const Item stop = item(lang::ProgramStop{lang::StopKind::optional_stop});
  push(stop);
  cycle();
  EXPECT_EQ(situation(), Situation::running);
  bench_.parts.switches.set_optional_stop(true);
  push(stop);
  cycle();
  EXPECT_EQ(situation(), Situation::held);
}

TEST_F(ItemWorkerTest, ARequestIsOpenUntilItIsAnswered) {
  push(Request(requests::StateRead{7}));
  cycle();
  ASSERT_NE(worker_.request(), nullptr);
  const auto* const read = std::get_if<requests::StateRead>(&worker_.request()->content);
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->channel, 7);
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
  push(RunEnd{.blocks = 12});
  cycle();
  EXPECT_EQ(situation(), Situation::ready);
  EXPECT_TRUE(bench_.parts.runs.ended_well(1));
  EXPECT_EQ(bench_.parts.switches.feed_override_in_force(), 0.5);
}

TEST_F(ItemWorkerTest, AFailedRunLeavesAnAlarm) {
  push(RunFailed{.code = FixedText<8>("E3008"), .text = ShortText("a number is divided by zero")});
  cycle();
  EXPECT_EQ(situation(), Situation::alarm);
  EXPECT_EQ(bench_.event(), "E3008");
  EXPECT_FALSE(bench_.parts.runs.ended_well(1));
}

TEST_F(ItemWorkerTest, WhereThePreparationBrokeOffTheAxesComeToRestAtOnce) {
  push(lang::Dwell{.seconds = 1000.0});
  cycle();
  EXPECT_EQ(situation(), Situation::running);
  push(BrokenOff{.code = FixedText<8>("A9001")});
  cycle();
  EXPECT_EQ(situation(), Situation::ending);
  EXPECT_EQ(bench_.event(), "A9001");
}

TEST_F(ItemWorkerTest, SingleBlockHoldsBeforeTheNextStatement) {
  bench_.parts.run.stepper().switch_on({.run = 1, .block = 1, .line = 10});
  Item output = item(lang::OutputCommand{.number = 1, .value = 1.0});
  output.tag.block = 2;
  push(output);
  cycle();
  EXPECT_FALSE(bench_.outputs.is_on(1));
  EXPECT_EQ(bench_.parts.run.hold_cause(), HoldCause::single_block);
  bench_.parts.run.resume();
  cycle();
  EXPECT_TRUE(bench_.outputs.is_on(1));
}

TEST_F(ItemWorkerTest, AResetDropsItemsUpToItsOwn) {
  const kinematics::Transform transform;
  Rest rest;
  push(lang::Dwell{});
  EXPECT_FALSE(worker_.drop_until_reset_done(rest));
  push(ResetDone{{&transform}});
  push(LoadDone{});
  EXPECT_TRUE(worker_.drop_until_reset_done(rest));
  EXPECT_EQ(rest.transform, &transform);
  EXPECT_EQ(bench_.link.items.size(), 1U);
}

TEST_F(ItemWorkerTest, AStartSaysWhereTheAxesStandAndWhatIsSkipped) {
  bench_.parts.switches.set_block_skip(2, true);
  bench_.parts.run.end_run(RunResult::succeeded, 0);
  worker_.begin_run(Job::line);
  const auto notice = std::get<LineStart>(bench_.notice());
  EXPECT_EQ(notice.start.run, 2U);
  EXPECT_EQ(notice.start.stand.axes_M[1], 20.0);
  EXPECT_EQ(notice.start.block_skip, 1U << 2);
}

}  // namespace
}  // namespace stanok::channels
