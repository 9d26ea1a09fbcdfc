// What a dry run keeps of a feed, without an interpreter.
#include "jobs/dry_run/dry_sink.h"

#include <gtest/gtest.h>

#include "channels/contract/motion_config.h"
#include "channels/preparation/preparation_parts.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::jobs {
namespace {

class DrySinkTest : public ::testing::Test {
 protected:
  DrySinkTest() {
    files_.texts["part.nc"] = "G94\nG1 X10 F600\nM30\n";
    Diagnostics warnings;
    program_ = *lang::compile("part.nc", files_, nullptr, warnings);
    feed_.set_program(program_);
    feed_.blocks().restart(schemes_.at(channel_.scheme).get(), {});
  }
  void begin(channels::FeedDepth depth) {
    sink_.begin(program_, depth, [this](const lang::Command&, const motion::PathBlock* block) {
      records_ += block == nullptr ? 'c' : 'b';
    });
    feed_.give_transform();
  }
  void take(lang::Payload payload) {
    lang::Command command;
    command.payload = std::move(payload);
    command.origin.line = 2;
    EXPECT_TRUE(feed_.take(command));
  }
  static lang::Move line_with_feed(double mm_per_min) {
    lang::Move move;
    move.kind = lang::MoveKind::line;
    move.words = 1;
    move.end[0] = 10.0;
    move.feed = mm_per_min;
    return move;
  }

  stanok::testing::MemoryFiles files_;
  channels::MachineConfig machine_ = stanok::testing::two_channel_machine();
  const channels::ChannelConfig& channel_ = machine_.channels[0];
  motion::MotionConfig motion_ = channels::motion_config(machine_, channel_);
  channels::SchemeSet schemes_ = channels::make_schemes(channel_);
  DrySink sink_{motion_, feed_};
  channels::PathFeed feed_{machine_, channel_, motion_, sink_};
  std::shared_ptr<const lang::Program> program_;
  std::string records_;
};

TEST_F(DrySinkTest, RecordsEachCommandOnceAndMotionWithItsBlock) {
  begin(channels::FeedDepth::positions);
  take(lang::Dwell{.seconds = 1.0});
  take(line_with_feed(600.0));
  EXPECT_EQ(records_, "cb");
}

TEST_F(DrySinkTest, WarnsOfAFeedThatTheAxesLimit) {
  begin(channels::FeedDepth::path);
  take(line_with_feed(15001.0));  // 250 mm/s are 15000 mm/min
  feed_.end_chain();
  ASSERT_TRUE(sink_.feed_warning());
  EXPECT_EQ(sink_.feed_warning()->code, "W810");
  EXPECT_EQ(sink_.feed_warning()->place.line, 2);
}

TEST_F(DrySinkTest, SaysNothingOfAFeedWithinTheLimits) {
  begin(channels::FeedDepth::path);
  take(line_with_feed(15000.0));
  feed_.end_chain();
  EXPECT_FALSE(sink_.feed_warning());
  EXPECT_TRUE(sink_.take_laws().empty());
}

}  // namespace
}  // namespace stanok::jobs
