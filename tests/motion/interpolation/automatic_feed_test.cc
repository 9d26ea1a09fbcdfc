// Feed laws that the cycle forms from a signal: the feed over the path against the laws'
// definition.
#include "motion/interpolation/automatic_feed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stanok::motion {
namespace {

constexpr double way_per_cycle = 0.01;  // mm

AutomaticFeedConfig law(LawKind kind) {
  return {.law = kind,
          .level = 6.0,
          .release = 4.0,
          .part_min = 0.6,
          .part_step = 0.1,
          .path_step_mm = 0.25,
          .on_at_start = true};
}

TEST(AutomaticFeed, LeavesTheFeedAloneBelowItsLevel) {
  AutomaticFeed feed(law(LawKind::modulated));
  for (int k = 0; k < 1000; ++k) {
    feed.advance(6.0, way_per_cycle);
    EXPECT_EQ(feed.part(), 1.0);
  }
  EXPECT_EQ(feed.state(), ModuleState::ready);
}

// 4 increments down to 0.6, 4 up again, one every 0.25 mm.
TEST(AutomaticFeed, ModulatesWhileTheVibrationIsStrong) {
  AutomaticFeed feed(law(LawKind::modulated));
  feed.advance(7.0, way_per_cycle);
  ASSERT_EQ(feed.state(), ModuleState::running);
  for (int k = 1; k <= 1000; ++k) {
    feed.advance(7.0, way_per_cycle);
    const double way = way_per_cycle * k;
    if (std::abs(way / 0.25 - std::round(way / 0.25)) < 1e-6) continue;  // on an increment
    const int in_cycle = static_cast<int>(way / 0.25) % 8;
    EXPECT_NEAR(feed.part(), 1.0 - 0.1 * std::min(in_cycle, 8 - in_cycle), 1e-12) << way;
  }
}

// Gone vibration: the cycle of modulation, 2 mm, is run to its end at the programmed feed.
TEST(AutomaticFeed, ModulationEndsAtTheProgrammedFeed) {
  AutomaticFeed feed(law(LawKind::modulated));
  feed.advance(7.0, 0.0);
  double way = 0.0;
  double part_before = 1.0;
  while (feed.state() == ModuleState::running && way < 10.0) {
    feed.advance(way < 0.9 ? 7.0 : 1.0, way_per_cycle);
    way += way_per_cycle;
    EXPECT_LE(std::abs(feed.part() - part_before), 0.1 + 1e-12);
    part_before = feed.part();
  }
  EXPECT_EQ(feed.state(), ModuleState::ready);
  EXPECT_NEAR(way, 2.0, 2.0 * way_per_cycle);
  EXPECT_EQ(feed.part(), 1.0);
}

// Between release and level the vibration neither starts nor ends the modulation.
TEST(AutomaticFeed, HasHysteresis) {
  AutomaticFeed feed(law(LawKind::modulated));
  for (int k = 0; k < 500; ++k) feed.advance(5.0, way_per_cycle);
  EXPECT_EQ(feed.state(), ModuleState::ready);
  feed.advance(6.5, way_per_cycle);
  for (int k = 0; k < 2000; ++k) feed.advance(5.0, way_per_cycle);
  EXPECT_EQ(feed.state(), ModuleState::running);
}

// A process whose power follows the feed: the feed settles within one increment of the level.
TEST(AutomaticFeed, LinearLawSettlesWhereTheSignalIsInItsBand) {
  AutomaticFeedConfig config = law(LawKind::linear);
  config.part_min = 0.2;
  config.part_step = 0.02;
  AutomaticFeed feed(config);
  const double full_power = 10.0;
  for (int k = 0; k < 3000; ++k) feed.advance(full_power * feed.part(), way_per_cycle);
  EXPECT_LE(full_power * feed.part(), 6.0 + 1e-9);
  EXPECT_GE(full_power * feed.part(), 4.0 - 1e-9);
  EXPECT_EQ(feed.state(), ModuleState::running);
  // 0.4 of the feed in steps of 0.02, one every 0.25 mm: 20 increments, 5 mm. Then the load falls.
  for (int k = 0; k < 700; ++k) feed.advance(1.0, way_per_cycle);
  EXPECT_EQ(feed.part(), 1.0);
  EXPECT_EQ(feed.state(), ModuleState::ready);
}

TEST(AutomaticFeed, ChangesWithThePathNotWithTime) {
  AutomaticFeed feed(law(LawKind::linear));
  for (int k = 0; k < 1000; ++k) feed.advance(9.0, 0.0);
  EXPECT_EQ(feed.part(), 1.0);
  for (int k = 0; k < 26; ++k) feed.advance(9.0, way_per_cycle);
  EXPECT_NEAR(feed.part(), 0.9, 1e-12);
  feed.advance(9.0, 10.0);  // several increments in one cycle, as far as the smallest feed
  EXPECT_NEAR(feed.part(), 0.6, 1e-12);
}

TEST(AutomaticFeed, LostSensorGivesTheSmallestFeedUntilItIsSwitchedAgain) {
  for (const auto lost : {std::optional<double>(), std::optional<double>(std::nan("")),
                          std::optional<double>(std::numeric_limits<double>::infinity())}) {
    AutomaticFeed feed(law(LawKind::linear));
    feed.advance(1.0, way_per_cycle);
    feed.advance(lost, way_per_cycle);
    EXPECT_EQ(feed.state(), ModuleState::fault);
    EXPECT_EQ(feed.part(), 0.6);
    feed.advance(1.0, way_per_cycle);
    EXPECT_EQ(feed.part(), 0.6);
    feed.switch_on();
    EXPECT_EQ(feed.state(), ModuleState::ready);
    EXPECT_EQ(feed.part(), 1.0);
  }
}

TEST(AutomaticFeed, ARestartSwitchesNothingOnThatIsOff) {
  AutomaticFeed feed(law(LawKind::linear));
  feed.advance(std::nullopt, way_per_cycle);
  EXPECT_EQ(feed.state(), ModuleState::fault);
  feed.restart();
  EXPECT_EQ(feed.state(), ModuleState::ready);
  EXPECT_EQ(feed.part(), 1.0);
  feed.switch_off();
  feed.restart();
  EXPECT_EQ(feed.state(), ModuleState::reset);
}

TEST(AutomaticFeed, OffItNeedsNoSensor) {
  AutomaticFeed feed(law(LawKind::modulated));
  feed.switch_off();
  feed.advance(std::nullopt, way_per_cycle);
  EXPECT_EQ(feed.state(), ModuleState::reset);
  EXPECT_EQ(feed.part(), 1.0);
}

}  // namespace
}  // namespace stanok::motion
