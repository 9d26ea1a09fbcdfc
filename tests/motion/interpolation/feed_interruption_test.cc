// The operator's interruption of the feed: rests at L_B of path apart, L_A / F long, on whatever
// path and under whatever override. Expected values by counting lengths.
#include <gtest/gtest.h>

#include "tests/motion/path_samples.h"
#include "tests/support/cycle.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

using stanok::testing::cycle_s;

// A rest on the path: where, and over how many cycles the axes stood.
struct Rest {
  double s = 0.0;
  double standing_s = 0.0;
};

std::vector<Rest> rests_of(const std::vector<Sample>& samples) {
  std::vector<Rest> rests;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    if (samples[k].out.state != PathState::standing) continue;
    if (samples[k - 1].out.state != PathState::standing) rests.push_back({samples[k].s, 0.0});
    rests.back().standing_s += cycle_s;
  }
  return rests;
}

// Interrupts from a cycle on.
std::function<void(int, Interpolator&)> interrupt_at(int at, InterruptionLengths lengths) {
  return [=](int k, Interpolator& interpolator) {
    if (k == at) interpolator.interrupt(lengths);
  };
}

FeedControl nominal(int) {
  return {};
}

// Path of feed up to each place: rapid segments do not count.
double feed_path(const std::vector<PathBuilder::Built>& built, double s) {
  double begin = 0.0;
  double counted = 0.0;
  for (const auto& one : built) {
    const double inside = std::clamp(s - begin, 0.0, one.segment.length);
    if (!one.segment.rapid) counted += inside;
    begin += one.segment.length;
  }
  return counted;
}

TEST(FeedInterruption, BeforeTheStartTheFirstRestIsBehindOneL_B) {
  ChainMaker chain(usual_limits);
  chain.line(20.0, 10.0).end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built(), nominal, 200000,
                                interrupt_at(0, {.stand_mm = 0.4, .cut_mm = 2.0}));
  const auto rests = rests_of(samples);
  // 20 / 2 places, of which the last one is the end, where there is no feed to interrupt any more.
  ASSERT_EQ(rests.size(), 9U);
  for (std::size_t k = 0; k < rests.size(); ++k) {
    EXPECT_NEAR(rests[k].s, 2.0 * static_cast<double>(k + 1), 1e-9);
    EXPECT_NEAR(rests[k].standing_s, 0.4 / 10.0, 2.0 * cycle_s);
  }
  EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
}

TEST(FeedInterruption, OnTheMoveItRestsAtOnceAndThenEveryL_B) {
  ChainMaker chain(usual_limits);
  chain.line(50.0, 40.0).end_chain();
  const int asked_at = 300;
  const auto samples = run_path(three_axes(usual_limits), chain.built(), nominal, 200000,
                                interrupt_at(asked_at, {.stand_mm = 1.0, .cut_mm = 3.0}));
  const auto rests = rests_of(samples);
  ASSERT_GE(rests.size(), 2U);
  // Braking distance of 40 mm/s with full jerk: v sqrt(v / j) = 1.13 mm.
  const double asked_s = samples[asked_at].s;
  EXPECT_GT(rests[0].s, asked_s);
  EXPECT_LT(rests[0].s, asked_s + 1.3);
  for (std::size_t k = 1; k < rests.size(); ++k)
    EXPECT_NEAR(rests[k].s - rests[k - 1].s, 3.0, 1e-9);
  for (const Rest& rest : rests) EXPECT_NEAR(rest.standing_s, 1.0 / 40.0, 2.0 * cycle_s);
}

TEST(FeedInterruption, RapidMovesAreNeitherCountedNorInterrupted) {
  ChainMaker chain(usual_limits);
  chain.line(5.0, 20.0).line(40.0, 1.0).as_rapid().line(5.0, 20.0).end_chain();
  chain.line(30.0, 1.0).as_rapid().end_chain().line(4.0, 20.0).end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built(), nominal, 200000,
                                interrupt_at(0, {.stand_mm = 0.5, .cut_mm = 3.0}));
  const auto rests = rests_of(samples);
  ASSERT_EQ(rests.size(), 4U);
  const double expected[] = {3.0, 46.0, 49.0, 82.0};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(rests[k].s, expected[k], 1e-9);
}

TEST(FeedInterruption, HoldAndOverrideChangeTheTimeNotThePlaces) {
  ChainMaker chain(usual_limits);
  chain.line(7.0, 30.0).arc(10.0, 3.0, 25.0).line(4.0, 30.0).end_chain();
  const auto settings = [](int k) {
    FeedControl control;
    control.feed_override = k < 700 ? 0.5 : 1.5;
    control.hold = k > 1000 && k < 1200;
    return control;
  };
  const auto samples = run_path(three_axes(usual_limits), chain.built(), settings, 200000,
                                interrupt_at(0, {.stand_mm = 0.25, .cut_mm = 2.5}));
  const auto rests = rests_of(samples);
  ASSERT_EQ(rests.size(), static_cast<std::size_t>(chain.length() / 2.5));
  for (std::size_t k = 0; k < rests.size(); ++k)
    EXPECT_NEAR(rests[k].s, 2.5 * static_cast<double>(k + 1), 1e-8);
}

TEST(FeedInterruption, OffTheFeedGoesOnWithoutARest) {
  ChainMaker chain(usual_limits);
  chain.line(50.0, 20.0).end_chain();
  const auto act = [](int k, Interpolator& interpolator) {
    if (k == 0) interpolator.interrupt({.stand_mm = 0.4, .cut_mm = 2.0});
    if (k == 1000) interpolator.interrupt({});
  };
  const auto samples = run_path(three_axes(usual_limits), chain.built(), nominal, 200000, act);
  const auto rests = rests_of(samples);
  ASSERT_FALSE(rests.empty());
  EXPECT_LT(rests.back().s, samples[1000].s + 1e-9);
  EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
}

// On any path, whatever the operator does with the override: rests lie L_B of feed path apart, the
// limits hold, the end is exact and nothing wedges.
TEST(FeedInterruption, LimitsAndPlacesHoldOnRandomPaths) {
  for (unsigned seed = 1; seed <= stanok::testing::cases(60U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    for (int k = 0; k < 60; ++k) {
      chain.line(std::pow(10.0, 3.0 * part(random) - 2.0), 5.0 + 95.0 * part(random));
      if (part(random) < 0.2) chain.as_rapid();
      if (part(random) < 0.1) chain.end_chain();
    }
    chain.end_chain();
    const InterruptionLengths lengths{.stand_mm = 0.5 + part(random),  // over a cycle
                                      .cut_mm = 0.05 + 4.0 * part(random)};
    FeedControl control;
    const auto settings = [&](int) {
      if (part(random) < 0.002) control.feed_override = 0.2 + 1.8 * part(random);
      if (part(random) < 0.002) control.hold = part(random) < 0.3;
      return control;
    };
    const auto samples = run_path(three_axes(usual_limits), chain.built(), settings, 400000,
                                  interrupt_at(static_cast<int>(300.0 * part(random)), lengths));
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, cycle_s).worst(), 1.000001);
    const auto rests = rests_of(samples);
    for (std::size_t k = 1; k < rests.size(); ++k) {
      const double apart =
          feed_path(chain.built(), rests[k].s) - feed_path(chain.built(), rests[k - 1].s);
      EXPECT_NEAR(apart, lengths.cut_mm, 1e-7) << "rest " << k;
    }
    const double behind = feed_path(chain.built(), samples.back().s) -
                          (rests.empty() ? 0.0 : feed_path(chain.built(), rests.back().s));
    EXPECT_LT(behind, lengths.cut_mm + 3.0);
  }
}

TEST(FeedInterruption, TheCycleAllocatesNothing) {
  ChainMaker chain(usual_limits);
  chain.line(10.0, 20.0).end_chain();
  PathQueue queue;
  LookAhead look_ahead(three_axes(usual_limits));
  for (const auto& built : chain.built()) look_ahead.add(built);
  ASSERT_TRUE(look_ahead.deliver(queue));
  Interpolator interpolator(three_axes(usual_limits));
  InterpolatorOutput out;
  const stanok::testing::NoAllocation forbidden;
  interpolator.interrupt({.stand_mm = 0.4, .cut_mm = 1.0});
  for (int k = 0; k < 2000; ++k) interpolator.advance(queue, {}, out);
}

}  // namespace
}  // namespace stanok::motion::testing
