// Feed laws that a channel forms from the sensors of its spindle, on running programs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using testing::MachineBench;
using ::testing::Not;

// Down to half the feed in 5 increments, one every 0.5 mm, above 6 um or 900 W.
MachineConfig lathe_with_automatic_feeds() {
  MachineConfig config = testing::turning_machine();
  for (const auto law : {motion::LawKind::modulated, motion::LawKind::linear}) {
    const double level = law == motion::LawKind::linear ? 900.0 : 6.0;
    config.channels[0].automatic_feeds.push_back({.law = law,
                                                  .level = level,
                                                  .release = 0.8 * level,
                                                  .part_min = 0.5,
                                                  .part_step = 0.1,
                                                  .path_step_mm = 0.5});
  }
  return config;
}

OperatorEvent automatic(AutomaticLaw law, Switch to) {
  OperatorEvent event;
  event.command = commands::ProcessAutomatic{law, to};
  event.channel = 1;
  return event;
}

constexpr const char* turning_program = "G0 X60 Z0\nG94 G1 Z-20 F600\nM30\n";

struct Moment {
  double way = 0.0;    // along Z
  double speed = 0.0;  // mm/s
};

std::vector<Moment> cut(MachineBench& bench) {
  bench.program("turn.nc", turning_program);
  bench.run(1, "turn.nc");
  std::vector<Moment> moments;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.process.feed_mm_per_min > 0.0)
      moments.push_back({-channel.axes[1].position, channel.path_speed});
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  return moments;
}

double slowest(const std::vector<Moment>& moments, double from, double to) {
  double speed = 1e9;
  for (const Moment& one : moments)
    if (one.way > from && one.way < to) speed = std::min(speed, one.speed);
  return speed;
}
double fastest(const std::vector<Moment>& moments, double from, double to) {
  double speed = 0.0;
  for (const Moment& one : moments)
    if (one.way > from && one.way < to) speed = std::max(speed, one.speed);
  return speed;
}

// 600 mm/min are 10 mm/s; 5 mm of path down and up again.
TEST(AutomaticFeedOfAChannel, ModulatesTheFeedUnderVibration) {
  MachineBench bench(lathe_with_automatic_feeds());
  bench.ask(automatic(AutomaticLaw::modulated, Switch::on));
  bench.sensors({{.power_w = 500.0, .vibration_um = 8.0, .vibration_hz = 120.0}});
  const auto moments = cut(bench);
  EXPECT_NEAR(slowest(moments, 2.0, 18.0), 5.0, 1e-6);
  EXPECT_NEAR(fastest(moments, 2.0, 18.0), 10.0, 1e-6);
  // Smallest feed from 2.5 to 3.0 mm, full feed again from 5.0 to 5.5 mm, within a cycle's way and
  // the ramps.
  EXPECT_NEAR(slowest(moments, 2.6, 2.9), 5.0, 1e-6);
  EXPECT_NEAR(fastest(moments, 2.6, 2.9), 5.0, 1e-6);
  EXPECT_NEAR(slowest(moments, 5.25, 5.45), 10.0, 1e-6);
}

TEST(AutomaticFeedOfAChannel, FollowsThePowerOfTheSpindle) {
  MachineBench bench(lathe_with_automatic_feeds());
  bench.ask(automatic(AutomaticLaw::linear, Switch::on));
  bench.sensors({{.power_w = 1000.0, .vibration_um = 0.0, .vibration_hz = 0.0}});
  const auto moments = cut(bench);
  // 5 increments of 0.1 over 2.5 mm, then the smallest feed.
  EXPECT_NEAR(fastest(moments, 2.7, 19.0), 5.0, 1e-6);
  EXPECT_NEAR(slowest(moments, 0.1, 0.4), 10.0, 1.0);
}

TEST(AutomaticFeedOfAChannel, OffOrBelowItsLevelItChangesNoBit) {
  MachineBench plain(testing::turning_machine());
  const auto expected = cut(plain);
  for (const double vibration : {2.0, 5.9}) {
    MachineBench bench(lathe_with_automatic_feeds());
    bench.ask(automatic(AutomaticLaw::modulated, Switch::on));
    bench.sensors({{.power_w = 2000.0, .vibration_um = vibration, .vibration_hz = 50.0}});
    const auto moments = cut(bench);
    ASSERT_EQ(moments.size(), expected.size());
    for (std::size_t k = 0; k < moments.size(); ++k) {
      ASSERT_EQ(moments[k].way, expected[k].way);
      ASSERT_EQ(moments[k].speed, expected[k].speed);
    }
  }
}

TEST(AutomaticFeedOfAChannel, LostSensorIsSaidAndTheFeedIsTheSmallest) {
  MachineBench bench(lathe_with_automatic_feeds());
  bench.ask(automatic(AutomaticLaw::modulated, Switch::on));
  const auto moments = cut(bench);  // no sensor at all
  EXPECT_THAT(bench.event_codes(), Contains("W604"));
  EXPECT_NEAR(fastest(moments, 0.0, 20.0), 5.0, 1e-6);
  EXPECT_EQ(bench.channel(1).process.automatic[0].state, motion::ModuleState::fault);

  MachineBench off(lathe_with_automatic_feeds());
  cut(off);
  EXPECT_THAT(off.event_codes(), Not(Contains("W604")));
}

TEST(AutomaticFeedOfAChannel, IsRefusedWhereTheMachineFileHasNone) {
  MachineBench bench(testing::turning_machine());
  bench.ask(automatic(AutomaticLaw::linear, Switch::on));
  bench.cycle();
  ASSERT_FALSE(bench.replies().empty());
  EXPECT_EQ(bench.replies().back().code.view(), "E6030");
}

// Each value that changes is an input of the cycle, on record.
TEST(AutomaticFeedOfAChannel, SensorsAreRecordedWhenTheyChange) {
  MachineBench bench(lathe_with_automatic_feeds(), {.on_at_start = true, .changes_kept_s = 1e-3});
  const auto records = [&](double power) {
    const std::array sensors{SpindleSensors{.power_w = power}};
    CycleOutput output;
    bench.machine().cycle({.events = {}, .feedback = {}, .sensors = sensors}, output);
    std::vector<SpindleInput> found;
    for (InputChange change; bench.machine().input_changes().pop(change);) {
      if (const auto* input = std::get_if<SpindleInput>(&change.content)) found.push_back(*input);
    }
    return found;
  };
  const auto first = records(700.0);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].value, 700.0);
  EXPECT_THAT(records(700.0), IsEmpty());
  const auto lost = records(std::nan(""));
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_TRUE(std::isnan(lost[0].value));
}

}  // namespace
}  // namespace stanok::channels
