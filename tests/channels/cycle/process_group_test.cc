// Laws of the cycle and force control, with a modifier of the feed that records what it is told.
#include "channels/cycle/process_group.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

class RecordedModifier : public motion::FeedModifier {
 public:
  [[nodiscard]] bool command(const motion::ForceCommand& order) RT_SAFE override {
    latest_command = order;
    return accepts;
  }
  [[nodiscard]] motion::FeedDemand advance(const motion::CutState& state) RT_SAFE override {
    cut = state;
    return {.feed_per_s = 3.0, .feed_max_per_s = 9.0};
  }
  [[nodiscard]] bool is_ready() const RT_SAFE override { return ready; }
  [[nodiscard]] motion::ForceEvent event() const RT_SAFE override {
    return motion::ForceEvent::overload_at_feed_min;
  }
  [[nodiscard]] motion::ForceStatus status() const RT_SAFE override { return {}; }

  motion::ForceCommand latest_command;
  motion::CutState cut;
  bool accepts = true;
  bool ready = true;
};

ChannelConstants constants_with(motion::FeedModifier* modifier) {
  ChannelConstants constants = bench_constants();
  constants.feed_modifier = modifier;
  constants.machine_spindle[0] = 1;
  constants.automatic_feeds[0] = {
      .law = motion::LawKind::modulated, .level = 10.0, .release = 5.0, .part_min = 0.25};
  return constants;
}

class ProcessGroupTest : public ::testing::Test {
 protected:
  RecordedModifier modifier_;
  CycleBench bench_{constants_with(&modifier_)};
  ProcessGroup& process_ = bench_.parts.process;
};

TEST_F(ProcessGroupTest, TakesTheSensorsOfItsOwnSpindle) {
  const std::array<SpindleSensors, 2> sensors{{{.power_w = 100.0}, {.power_w = 250.0}}};
  process_.sense(sensors);
  static_cast<void>(process_.advance(1.0));
  EXPECT_EQ(modifier_.cut.power_w, 250.0);
}

TEST_F(ProcessGroupTest, TellsTheModifierWhereTheToolIsAndHowTheSpindleTurns) {
  bench_.cycles(1);
  static_cast<void>(process_.advance(0.7));
  EXPECT_EQ(modifier_.cut.transverse_mm, 10.0);
  EXPECT_EQ(modifier_.cut.transverse_code, 10000);
  EXPECT_EQ(modifier_.cut.increment_mm, bench_resolution);
  EXPECT_EQ(modifier_.cut.feed_override, 0.7);
  EXPECT_TRUE(modifier_.cut.frame_is_new);
  static_cast<void>(process_.advance(0.7));
  EXPECT_FALSE(modifier_.cut.frame_is_new);
}

TEST_F(ProcessGroupTest, CountsTheTimesThatTheSpindleBeginsToTurn) {
  lang::SpindleCommand command;
  command.speed_rev_per_min = 60.0;
  for (const auto action : {lang::SpindleAction::clockwise, lang::SpindleAction::clockwise,
                            lang::SpindleAction::counter_clockwise}) {
    command.action = action;
    bench_.parts.spindles.command(command);
    static_cast<void>(process_.advance(1.0));
  }
  EXPECT_EQ(modifier_.cut.spindle_starts, 2U);
}

TEST_F(ProcessGroupTest, WhatTheModifierAsksForIsTheFeedOfTheLinearAxes) {
  EXPECT_EQ(process_.advance(1.0), motion::ForceEvent::overload_at_feed_min);
  motion::FeedControl control;
  process_.apply(control);
  EXPECT_EQ(control.controlled_per_s, 3.0);
  EXPECT_EQ(control.controlled_max_per_s, 9.0);
  EXPECT_EQ(control.controlled_axes, 1U << bench_x | 1U << bench_y);
}

TEST_F(ProcessGroupTest, WithoutForceControlThereIsNothingToOrder) {
  CycleBench bare;
  EXPECT_FALSE(bare.parts.process.has_force_control());
  EXPECT_FALSE(bare.parts.process.command({}));
  EXPECT_TRUE(bare.parts.process.is_ready());
  EXPECT_EQ(bare.parts.process.advance(1.0), motion::ForceEvent::none);
}

TEST_F(ProcessGroupTest, ALawThatLosesItsSensorTakesTheSmallestFeedAndSaysSoOnce) {
  ASSERT_TRUE(process_.switch_law(motion::LawKind::modulated, Switch::on));
  EXPECT_FALSE(process_.switch_law(motion::LawKind::linear, Switch::on));
  EXPECT_EQ(process_.form_feed(), 0.25);  // no sensor has told anything
  EXPECT_EQ(bench_.event(), "W604");
  EXPECT_EQ(process_.form_feed(), 0.25);
  EXPECT_EQ(bench_.event(), "none");
}

}  // namespace
}  // namespace stanok::channels
