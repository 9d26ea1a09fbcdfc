// The parts of force control and of its power watch, each alone.
#include <gtest/gtest.h>

#include <cmath>

#include "process/adaptive/feed_clamps.h"
#include "process/adaptive/force_events.h"
#include "process/adaptive/radius_counter.h"
#include "process/adaptive/sensor_count.h"

namespace stanok::process {
namespace {

using motion::ForceEvent;

TEST(FeedClamps, ThoseOfTheProgramGoBeforeThoseOfTheMachineFile) {
  const ForceControlConfig config{.feed_min = 1.0, .feed_max = 4.0};
  const motion::CutState cut{.feed_programmed = 10.0};
  const FeedClamps program(motion::ForceCommand{.feed_min = 120.0, .feed_max = 180.0});
  EXPECT_EQ(program.resolve(config, cut)->min, 2.0);  // mm/s
  EXPECT_EQ(program.resolve(config, cut)->max, 3.0);
  EXPECT_EQ(FeedClamps().resolve(config, cut)->min, 1.0);
  EXPECT_EQ(FeedClamps().resolve(config, cut)->max, 4.0);
  EXPECT_EQ(FeedClamps().resolve({}, cut)->min, 0.5) << "a twentieth of the programmed feed";
  EXPECT_EQ(FeedClamps().resolve({}, cut)->max, 10.0);
  EXPECT_FALSE(FeedClamps().resolve({}, {}).has_value()) << "rapid";
}

// 0.1 and 0.3 mm/rev at 600 rev/min.
TEST(FeedClamps, PerRevolutionTheyGoWithTheSpindle) {
  const FeedClamps clamps(
      motion::ForceCommand{.feed_min = 0.1, .feed_max = 0.3, .per_revolution = true});
  const auto limits = clamps.resolve({}, motion::CutState{.rev_per_min = 600.0});
  ASSERT_TRUE(limits.has_value());
  EXPECT_DOUBLE_EQ(limits->min, 1.0);
  EXPECT_DOUBLE_EQ(limits->max, 3.0);
}

TEST(ForceEvents, TheFirstEventOfACycleIsTold) {
  ForceEvents events;
  events.note(ForceEvent::none);
  events.note(ForceEvent::sensor_lost);
  events.note(ForceEvent::no_answer);
  EXPECT_EQ(events.event(), ForceEvent::sensor_lost);
  events.begin_cycle();
  EXPECT_EQ(events.event(), ForceEvent::none);
}

TEST(ForceEvents, WhatLastsIsToldOnceUntilItIsAskedForAgain) {
  ForceEvents events;
  events.set_overloaded(true);
  EXPECT_EQ(events.event(), ForceEvent::overload_at_feed_min);
  events.begin_cycle();
  events.set_overloaded(true);
  EXPECT_EQ(events.event(), ForceEvent::none);
  events.tell_again();
  events.set_overloaded(true);
  EXPECT_EQ(events.event(), ForceEvent::overload_at_feed_min);
  events.begin_cycle();
  events.set_vibration_lost(true);
  EXPECT_EQ(events.event(), ForceEvent::vibration_lost);
  events.begin_cycle();
  events.set_vibration_lost(false);
  events.set_vibration_lost(true);
  EXPECT_EQ(events.event(), ForceEvent::vibration_lost) << "it began again";
}

TEST(CutRadius, ANewFrameMovesTheCounterWhileTheSlideStands) {
  CutRadius radius;
  motion::CutState cut;
  cut.transverse_mm = 100.0;
  cut.transverse_code = 100'000;
  cut.increment_mm = 0.001;
  cut.radius_mm = 40.0;
  cut.frame_is_new = true;
  radius.count(cut);
  EXPECT_NEAR(radius.counter().radius_mm(), 40.0, 1e-9);
  cut.frame_is_new = false;
  cut.transverse_code = 99'000;
  radius.count(cut);
  EXPECT_NEAR(radius.counter().radius_mm(), 39.0, 1e-9);
}

// A sensor that counts whole watts and shows three of them now and then.
TEST(SensorCount, TheSmallestStepIsTheCount) {
  SensorCount count;
  double power_w = 100.0;
  for (int k = 0; k < 100; ++k) count.learn(power_w += k % 4 == 0 ? 3.0 : 0.0);
  EXPECT_EQ(count.count_w(), 3.0);
  count.learn(power_w + 1.0);
  EXPECT_EQ(count.count_w(), 1.0);
  EXPECT_GE(count.usual_step_w(), count.count_w());
  EXPECT_TRUE(count.is_within_flicker(106.5, 100.0));
  EXPECT_FALSE(count.is_within_flicker(106.6, 100.0));
}

}  // namespace
}  // namespace stanok::process
