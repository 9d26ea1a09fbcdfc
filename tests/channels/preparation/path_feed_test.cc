// What becomes of commands, without an interpreter and without a cycle.
#include "channels/preparation/path_feed.h"

#include <gtest/gtest.h>

#include "channels/messages/channel_link.h"
#include "tests/channels/preparation/feed_bench.h"

namespace stanok::channels {
namespace {

TEST(PathFeedTest, AnItemComesBehindThePathBeforeIt) {
  FeedBench bench;
  ASSERT_TRUE(bench.take(FeedBench::line_to_x(10.0)));
  EXPECT_EQ(bench.sink.events, "");  // the chain is open: its last block may be shortened
  const auto taken = bench.take(lang::Dwell{.seconds = 0.5});
  ASSERT_TRUE(taken);
  EXPECT_TRUE(taken->gives);
  EXPECT_EQ(bench.sink.events, "si");
  ASSERT_EQ(bench.sink.items.size(), 1U);
  EXPECT_EQ(std::get<lang::Dwell>(bench.sink.items[0].content).seconds, 0.5);
  EXPECT_EQ(bench.sink.items[0].tag.run, 3U);
  EXPECT_EQ(bench.sink.items[0].tag.block, 2U);
}

TEST(PathFeedTest, ARemarkAndARiderLeaveTheChainOpen) {
  FeedBench bench;
  ASSERT_TRUE(bench.take(FeedBench::line_to_x(10.0)));
  ASSERT_TRUE(bench.take(lang::Message{}));
  ASSERT_TRUE(bench.take(lang::OutputCommand{.with_motion = true}));
  EXPECT_EQ(bench.sink.events, "nr");
  bench.feed.end_chain();
  EXPECT_EQ(bench.sink.events, "nrs");
}

TEST(PathFeedTest, AChainWithVeryManyRidersEnds) {
  FeedBench bench;
  ASSERT_TRUE(bench.take(FeedBench::line_to_x(10.0)));
  const lang::OutputCommand output{.with_motion = true};
  for (std::size_t k = 1; k < riders_in_chain_max; ++k) ASSERT_TRUE(bench.take(output));
  EXPECT_EQ(bench.sink.events.find('s'), std::string::npos);
  ASSERT_TRUE(bench.take(output));
  EXPECT_EQ(bench.sink.events.back(), 's');
}

TEST(PathFeedTest, WhatAnAxisCannotReachIsRefusedAndThePathGoesOnBehindIt) {
  FeedBench bench;
  ASSERT_TRUE(bench.take(FeedBench::line_to_x(10.0)));
  const auto refused = bench.take(FeedBench::line_to_x(501.0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "E5101");
  EXPECT_EQ(bench.sink.events, "s");  // what comes before is carried out
  EXPECT_EQ(bench.feed.blocks().position_W()[0], 501.0);
  EXPECT_FALSE(bench.take(FeedBench::line_to_x(20.0)));  // it begins where the axis cannot be
  EXPECT_TRUE(bench.take(FeedBench::line_to_x(30.0)));
}

TEST(PathFeedTest, AtTheDepthOfPositionsNothingBecomesAPath) {
  FeedBench bench(FeedDepth::positions);
  const auto taken = bench.take(FeedBench::line_to_x(501.0));
  ASSERT_TRUE(taken);
  EXPECT_TRUE(taken->gives);
  ASSERT_TRUE(bench.take(lang::Dwell{.seconds = 0.5}));
  EXPECT_EQ(bench.sink.events, "i");
  EXPECT_EQ(bench.feed.blocks().position_W()[0], 501.0);
  EXPECT_FALSE(bench.take(FeedBench::line_to_x(501.0))->gives);  // it stands there
}

TEST(PathFeedTest, AProbingMoveNeedsAProbeInEveryDepth) {
  for (const FeedDepth depth : {FeedDepth::positions, FeedDepth::path}) {
    lang::ProbeMove move;
    move.line = FeedBench::line_to_x(10.0);
    FeedBench without(depth);
    const auto refused = without.take(move);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "E4323");
    MachineConfig machine = stanok::testing::two_channel_machine();
    machine.channels[0].probe_input = 0;
    FeedBench with(depth, machine);
    ASSERT_TRUE(with.take(move));
    ASSERT_EQ(with.sink.items.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<ProbeBegin>(with.sink.items[0].content));
    EXPECT_EQ(with.sink.blocks.size(), 1U);
  }
}

TEST(PathFeedTest, TheEndOfAProgramTellsItsBlocks) {
  FeedBench bench;
  ASSERT_TRUE(bench.take(lang::Dwell{.seconds = 0.5}));
  const auto taken = bench.take(lang::ProgramEnd{});
  ASSERT_TRUE(taken);
  EXPECT_TRUE(taken->ends);
  EXPECT_EQ(std::get<RunEnd>(bench.sink.items.back().content).blocks, 2U);
}

TEST(PathFeedTest, ACommandCanPassIntoAnotherSink) {
  FeedBench bench;
  RememberingSink other(FeedDepth::positions);
  bench.command.payload = lang::Dwell{.seconds = 0.5};
  ASSERT_TRUE(bench.feed.pass(bench.command, other));
  EXPECT_EQ(other.events, "i");
  EXPECT_EQ(other.commands, 1);
  ASSERT_TRUE(bench.take(lang::Dwell{.seconds = 0.5}));
  EXPECT_EQ(other.events, "i");
  EXPECT_EQ(bench.sink.events, "i");
}

}  // namespace
}  // namespace stanok::channels
