// The control on a lathe that it does not know (tests/process/turned_part.h): steps of depth and
// hardness, cuts with gaps, sensors that lie, forces that are missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/process/turned_part.h"

namespace stanok::process {
namespace {

using motion::ForceEvent;
using ::testing::IsEmpty;
using testing::TurnedPart;
using testing::TurnedScene;

constexpr double force_set_n = 1200.0;

ForceControlConfig lathe_config() {
  return {.efficiency = 0.85, .power_lag_s = 0.025, .lighter_max = 1.0};
}

struct PartStep {
  const char* name;
  double rev_per_min;
  double depth_before, depth_after;
  double hardness_before, hardness_after;
};
void PrintTo(const PartStep& step, std::ostream* out) {
  *out << step.name;
}

class ForceOnAPart : public ::testing::TestWithParam<PartStep> {};

// Within 2 % after 1.5 s, or 12 turns where these take longer; at most 5 % beyond on the way back.
TEST_P(ForceOnAPart, ComesBackAfterAStep) {
  const PartStep& step = GetParam();
  constexpr double place_mm = 30.0;
  TurnedPart part(lathe_config(), {.rev_per_min = step.rev_per_min});
  part.depth_mm = [&](double z, double) {
    return z < place_mm ? step.depth_before : step.depth_after;
  };
  part.hardness_hb = [&](double z) {
    return z < place_mm ? step.hardness_before : step.hardness_after;
  };
  part.begin(force_set_n);
  part.run_to(place_mm - 0.2, 300.0);
  EXPECT_NEAR(part.force_n, force_set_n, 0.01 * force_set_n);
  part.run_to(place_mm, 300.0);
  const double from = part.time_s;
  // A lighter cut takes a step of the feed after the other.
  const bool is_lighter =
      step.depth_after < step.depth_before || step.hardness_after < step.hardness_before;
  const double limit_s = std::max(is_lighter ? 6.0 : 1.5, 12.0 * 60.0 / step.rev_per_min);
  double settled_s = 0.0;
  double beyond = 0.0;
  double sign = 0.0;
  part.run_to(1e9, 3.0 * limit_s, [&] {
    const double error = part.force_n / force_set_n - 1.0;
    if (std::abs(error) > 0.02) settled_s = part.time_s - from;
    if (sign == 0.0 && std::abs(error) > 0.1) sign = error < 0.0 ? -1.0 : 1.0;
    beyond = std::max(beyond, -sign * error);
  });
  RecordProperty("settling_s", std::to_string(settled_s));
  RecordProperty("overshoot_percent", std::to_string(100.0 * beyond));
  EXPECT_LE(settled_s, limit_s);
  EXPECT_LE(beyond, 0.05);
  EXPECT_THAT(part.events, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Steps, ForceOnAPart,
                         ::testing::Values(PartStep{"deeper", 600, 2, 3, 200, 200},
                                           PartStep{"shallower", 600, 3, 2, 200, 200},
                                           PartStep{"harder", 600, 2, 2, 200, 260},
                                           PartStep{"softer", 600, 2, 2, 260, 170},
                                           PartStep{"deeper_slow", 150, 2, 3, 200, 200},
                                           PartStep{"softer_fast", 1500, 2, 2, 260, 170}),
                         [](const auto& test) { return std::string(test.param.name); });

struct Gaps {
  std::string name;
  double rev_per_min = 600.0;
  int count = 1;
  double air = 0.25;  // part of the turn
  double noise = 0.0;
};
void PrintTo(const Gaps& gaps, std::ostream* out) {
  *out << gaps.name;
}

class ForceBetweenGaps : public ::testing::TestWithParam<Gaps> {};

// The greatest force of each turn, from 60 turns or 12 s after the entry on: by then the feed has
// risen step by step.
TEST_P(ForceBetweenGaps, IsHeldAtItsPeak) {
  const Gaps& gaps = GetParam();
  TurnedPart part(lathe_config(), {.rev_per_min = gaps.rev_per_min, .noise = gaps.noise});
  part.depth_mm = [&](double z, double angle) {
    const double place = std::fmod(gaps.count * angle, 1.0);
    const double depth = z < 80.0 ? 2.0 : z < 140.0 ? 2.6 : 2.0;
    return place < 1.0 - gaps.air ? depth : 0.0;
  };
  part.begin(force_set_n);
  part.run_to(0.0, 10.0);
  const double turn_s = 60.0 / gaps.rev_per_min;
  part.run_to(1e9, std::max(12.0, 60.0 * turn_s));
  double most = 0.0;
  double least = 1e9;
  double of_turn = 0.0;
  double turn_begun_s = part.time_s;
  const auto follow = [&] {
    of_turn = std::max(of_turn, part.force_most_n);
    if (part.time_s - turn_begun_s < turn_s) return;
    turn_begun_s = part.time_s;
    most = std::max(most, of_turn);
    least = std::min(least, of_turn);
    of_turn = 0.0;
  };
  part.run_to(79.5, 100.0, follow);
  RecordProperty("peak_least", std::to_string(least / force_set_n));
  RecordProperty("peak_most", std::to_string(most / force_set_n));
  EXPECT_GE(least, 0.9 * force_set_n);
  EXPECT_LE(most, 1.05 * force_set_n);
  // After a step of depth the peak comes back.
  part.run_to(80.0, 100.0);
  part.run_to(139.5, std::max(4.0, 40.0 * turn_s));
  most = of_turn = 0.0;
  least = 1e9;
  turn_begun_s = part.time_s;
  part.run_to(139.5, 100.0, follow);
  EXPECT_GE(least, 0.9 * force_set_n);
  EXPECT_LE(most, 1.05 * force_set_n);
  EXPECT_FALSE(part.is_fault());
}

std::vector<Gaps> interrupted_cuts() {
  std::vector<Gaps> all;
  for (const double rev_per_min : {120.0, 300.0, 600.0}) {
    for (const int count : {1, 2, 4}) {
      if (rev_per_min * count > 1300.0) continue;
      const std::string place =
          std::to_string(std::lround(rev_per_min)) + "_" + std::to_string(count);
      all.push_back({.name = "at_" + place, .rev_per_min = rev_per_min, .count = count});
      all.push_back(
          {.name = "noisy_at_" + place, .rev_per_min = rev_per_min, .count = count, .noise = 0.03});
      all.push_back(
          {.name = "half_at_" + place, .rev_per_min = rev_per_min, .count = count, .air = 0.5});
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Turns, ForceBetweenGaps, ::testing::ValuesIn(interrupted_cuts()),
                         [](const auto& test) { return test.param.name; });

// A cut without gaps has nothing of it, whatever noise it has and wherever it steps.
TEST(InterruptedCut, IsNotSeenInAFullCut) {
  for (const double rev_per_min : {100.0, 300.0, 600.0, 1500.0}) {
    TurnedPart part(lathe_config(), {.rev_per_min = rev_per_min, .noise = 0.03});
    InterruptedCut cut(lathe_config());
    part.depth_mm = [](double z, double) { return z < 10.0 ? 2.0 : z < 20.0 ? 3.0 : 1.8; };
    part.begin(force_set_n);
    int interrupted = 0;
    part.run_to(30.0, 60.0, [&] {
      cut.follow({.cycle_s = 0.001,
                  .turns_per_s = rev_per_min / 60.0,
                  .cutting_w = part.control.status().power_w - 250.0,
                  .feeds = true});
      interrupted += cut.is_interrupted() ? 1 : 0;
    });
    EXPECT_EQ(interrupted, 0) << rev_per_min;
  }
}

struct Lie {
  std::string name;
  std::function<double(double honest_w, double at_begin_w, int call)> shown;
  bool is_dead = true;  // and not of another gain, which nothing tells from a lighter cut
  double lighter_max = 0.09;
};
void PrintTo(const Lie& lie, std::ostream* out) {
  *out << lie.name;
}

class SensorThatLies : public ::testing::TestWithParam<Lie> {};

// From a steady cut on; the part becomes neither lighter nor heavier.
TEST_P(SensorThatLies, RaisesTheForceByATenthAtMost) {
  const Lie& lie = GetParam();
  ForceControlConfig with = lathe_config();
  with.lighter_max = lie.lighter_max;
  TurnedPart part(with, {});
  part.begin(force_set_n);
  part.run_to(10.0, 60.0);
  ASSERT_NEAR(part.force_n, force_set_n, 0.01 * force_set_n);
  const double begin_w = 250.0 + part.cutting_power_w();
  int call = 0;
  part.sensor = [&](double honest_w) { return lie.shown(honest_w, begin_w, call++); };
  double most = 0.0;
  part.run_to(1e9, 20.0, [&] { most = std::max(most, part.force_most_n); });
  RecordProperty("force_most", std::to_string(most / force_set_n));
  EXPECT_LE(most, 1.1 * force_set_n);
  EXPECT_EQ(part.is_fault(), lie.is_dead);
}

std::vector<Lie> lies() {
  std::vector<Lie> all;
  for (const double part : {0.5, 0.8, 0.9}) {
    const std::string percent = std::to_string(std::lround(100.0 * part));
    all.push_back({.name = "stuck_at_" + percent, .shown = [=](double, double begin_w, int) {
                     return std::round(250.0 + part * (begin_w - 250.0));
                   }});
    all.push_back({.name = "flickers_at_" + percent, .shown = [=](double, double begin_w, int k) {
                     return std::round(250.0 + part * (begin_w - 250.0)) + k % 3 - 1;
                   }});
  }
  all.push_back({.name = "half_the_gain",
                 .shown = [](double honest_w, double,
                             int) { return 250.0 + std::round(0.5 * (honest_w - 250.0)); },
                 .is_dead = false});
  all.push_back({.name = "three_quarters_of_the_gain",
                 .shown = [](double honest_w, double,
                             int) { return 250.0 + std::round(0.75 * (honest_w - 250.0)); },
                 .is_dead = false});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Lies, SensorThatLies, ::testing::ValuesIn(lies()),
                         [](const auto& test) { return test.param.name; });

// Without a word on the engagement a gain that is lost in the cut looks like a lighter cut; in the
// air it shows, as the power is below that of the idling spindle.
TEST(ClosedLoop, AGainThatIsLostIsFoundInTheAir) {
  TurnedPart part(lathe_config(), {});
  part.depth_mm = [](double z, double) { return z < 10.0 ? 2.0 : 0.0; };
  part.begin(force_set_n);
  part.run_to(10.5, 60.0);
  part.sensor = [](double honest_w) { return std::round(0.5 * honest_w); };
  part.run_to(1e9, 0.6);
  EXPECT_TRUE(part.is_fault());
}

TEST(ClosedLoop, ABrokenToolIsTold) {
  TurnedPart part(lathe_config(), {});
  bool is_broken = false;
  part.depth_mm = [&](double, double) { return is_broken ? 0.0 : 2.0; };
  part.begin(force_set_n);
  part.run_to(10.0, 60.0);
  EXPECT_THAT(part.events, IsEmpty());
  is_broken = true;
  part.run_to(1e9, 4.5);
  EXPECT_THAT(part.events, IsEmpty());
  part.run_to(1e9, 20.0);
  EXPECT_THAT(part.events, ::testing::ElementsAre(ForceEvent::force_missing));
}

// A cut that is too light for the set force at S_max, and one behind a wrong idle power.
TEST(ClosedLoop, AForceThatIsTooLowAtTheGreatestFeedIsTold) {
  TurnedPart part(lathe_config(), {});
  part.depth_mm = [](double, double) { return 0.5; };
  part.begin(force_set_n, 300.0);
  part.run_to(1e9, 30.0);
  EXPECT_THAT(part.events, ::testing::ElementsAre(ForceEvent::force_missing));
  EXPECT_NEAR(part.feed, 300.0 / 60.0, 0.02 * 300.0 / 60.0);
}

}  // namespace
}  // namespace stanok::process
