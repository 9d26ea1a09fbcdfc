// Dead power sensors are found whatever they show, before the feed has risen by more than a step;
// sound ones are not accused, whatever is cut.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/process/cut_bench.h"

namespace stanok::process {
namespace {

using motion::ForceEvent;
using motion::ForceState;
using testing::CutBench;
using testing::force_command;

ForceControlConfig config_of_watch() {
  return {.efficiency = 0.85, .power_lag_s = 0.025, .lighter_max = 1.0};
}

// In the cut with the force held; the sensor sound until now.
void hold_force(CutBench& bench) {
  ASSERT_TRUE(bench.control.command(force_command(1200.0)));
  bench.wait_until_ready();
  bench.cut_at_feed();
  bench.run(0.5);
  bench.depth_mm = 2.0;
  bench.run(15.0);
  ASSERT_EQ(bench.control.status().state, ForceState::regulating);
}

bool is_fault(const CutBench& bench) {
  return bench.control.status().state == ForceState::fault;
}

struct DeadSensor {
  std::string name;
  double part = 1.0;         // of the power of the cut that it shows
  int flicker = 0;           // counts to either side
  double drift_per_s = 0.0;  // of that power
  double noise = 0.0;        // of that power, standard deviation
};
void PrintTo(const DeadSensor& sensor, std::ostream* out) {
  *out << sensor.name;
}

class DeadSensorOn : public ::testing::TestWithParam<DeadSensor> {};

TEST_P(DeadSensorOn, IsNotLedToTheGreatestFeed) {
  const DeadSensor& dead = GetParam();
  CutBench bench(config_of_watch());
  hold_force(bench);
  const double before = bench.feed;
  const double idle = bench.control.status().power_idle_w;
  const double cut_w = bench.cut.power_w - idle;
  std::mt19937 random(20U + static_cast<unsigned>(dead.flicker));
  std::uniform_int_distribution<int> flicker(-dead.flicker, dead.flicker);
  std::normal_distribution<double> noise(0.0, 1.0);
  const double from = bench.time_s;
  bench.sensor = [&](double) {
    const double shown = dead.part + dead.drift_per_s * (bench.time_s - from);
    return std::round(idle + cut_w * shown * (1.0 + dead.noise * noise(random))) + flicker(random);
  };
  double feed_most = 0.0;
  bench.run(20.0, [&] { feed_most = std::max(feed_most, bench.feed); });
  RecordProperty("feed_most_over_before", std::to_string(feed_most / before));
  EXPECT_LE(feed_most, 1.1 * 1.006 * before);
  EXPECT_TRUE(is_fault(bench));
  EXPECT_THAT(bench.events,
              ::testing::Contains(::testing::AnyOf(ForceEvent::no_answer, ForceEvent::stays_high)));
}

std::vector<DeadSensor> dead_sensors() {
  std::vector<DeadSensor> all;
  for (const double part : {0.15, 0.3, 0.6, 0.9, 0.96, 1.3, 3.0}) {
    for (const int flicker : {0, 1, 2, 3}) {
      all.push_back({.name = "at_" + std::to_string(std::lround(100.0 * part)) + "_flicker_" +
                             std::to_string(flicker),
                     .part = part,
                     .flicker = flicker});
    }
  }
  for (const double drift : {-0.02, -0.005, 0.005, 0.01}) {
    all.push_back({.name = std::string(drift < 0.0 ? "falls_" : "rises_") +
                           std::to_string(std::lround(std::abs(1000.0 * drift))),
                   .part = 0.8,
                   .flicker = 2,
                   .drift_per_s = drift});
  }
  for (const double noise : {0.005, 0.01}) {
    all.push_back({.name = "noise_" + std::to_string(std::lround(1000.0 * noise)),
                   .part = 0.8,
                   .noise = noise});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Shown, DeadSensorOn, ::testing::ValuesIn(dead_sensors()),
                         [](const auto& test) { return test.param.name; });

// A workpiece at random: cylinders, steps, tapers both ways, hard places, gaps; a noisy sensor.
class SoundSensor : public ::testing::TestWithParam<unsigned> {};

TEST_P(SoundSensor, IsNeverFoundStuck) {
  const unsigned seed = GetParam();
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  CutBench bench(config_of_watch(), {.rev_per_min = between(150.0, 2000.0)});
  const double noise = seed % 3 == 0 ? 0.0 : between(0.005, 0.09);
  const double count = seed % 2 == 0 ? 1.0 : 10.0;
  std::normal_distribution<double> gauss(0.0, 1.0);
  bench.sensor = [&](double power_w) {
    const double cut_w = power_w - bench.idle_w();
    return count * std::round((bench.idle_w() + cut_w * (1.0 + noise * gauss(random))) / count);
  };
  ASSERT_TRUE(bench.control.command(force_command(between(400.0, 2000.0), 10.0, 1200.0)));
  bench.wait_until_ready();
  bench.cut_at_feed();
  bench.run(0.5);
  for (int stretch = 0; stretch < 25; ++stretch) {
    const double from = bench.depth_mm;
    const double to = stretch % 6 == 5 ? 0.0 : between(0.8, 5.0);
    const bool is_taper = from > 0.0 && to > 0.0 && stretch % 2 == 0;
    const double seconds = between(0.3, 12.0);
    const double begin = bench.time_s;
    if (stretch % 4 == 3) bench.hardness_hb = between(150.0, 300.0);
    const double override_after = stretch % 5 == 4 ? between(0.3, 1.0) : 1.0;
    if (!is_taper) bench.depth_mm = to;
    bench.run(seconds, [&] {
      const double part = (bench.time_s - begin) / seconds;
      if (part > 0.5) bench.cut.feed_override = override_after;
      if (is_taper) bench.depth_mm = from + (to - from) * part;
    });
    ASSERT_FALSE(is_fault(bench)) << "seed " << seed << ", stretch " << stretch << ", depth "
                                  << from << " to " << to << " in " << seconds << " s, override "
                                  << bench.cut.feed_override << ", noise " << noise << ", "
                                  << bench.cut.rev_per_min << " rev/min";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SoundSensor, ::testing::Range(1U, 101U));

// In the air there is no answer, and nothing to judge: the feed may be anything.
TEST(DeadSensors, JudgesNothingInTheAir) {
  CutBench bench(config_of_watch());
  hold_force(bench);
  bench.depth_mm = 0.0;
  bench.sensor = [&](double) { return 250.0; };
  for (const double feed_override : {1.0, 0.3, 1.0, 0.5}) {
    bench.cut.feed_override = feed_override;
    bench.run(5.0);
  }
  EXPECT_FALSE(is_fault(bench));
  EXPECT_THAT(bench.events, ::testing::ElementsAre(ForceEvent::force_missing)) << "only told";
}

// The same inputs give the same bits: a log is repeated with what it holds.
TEST(DeadSensors, GivesTheSameBitsEveryTime) {
  const auto feeds = [] {
    CutBench bench(config_of_watch());
    hold_force(bench);
    bench.sensor = [](double power_w) { return std::round(0.8 * power_w); };
    std::vector<double> all;
    bench.run(6.0, [&] {
      bench.depth_mm -= 1e-4;
      all.push_back(bench.feed);
    });
    return all;
  };
  EXPECT_EQ(feeds(), feeds());
}

// The feed follows a taper step by step, as far as the power answers.
TEST(DeadSensors, KeepsTheForceOnATaper) {
  CutBench bench(config_of_watch());
  hold_force(bench);
  const double begin = bench.time_s;
  double least = 1200.0;
  bench.run(20.0, [&] {
    bench.depth_mm = 2.0 - 0.03 * (bench.time_s - begin);
    least = std::min(least, bench.force_n);
  });
  EXPECT_FALSE(is_fault(bench));
  EXPECT_GE(least, 0.9 * 1200.0);
  RecordProperty("force_least", std::to_string(least));
}

}  // namespace
}  // namespace stanok::process
