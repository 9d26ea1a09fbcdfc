// Feed hold, resume and override in the cycle: limits, rest, exact speeds and ends, whatever the
// operator does.
#include <gtest/gtest.h>

#include "tests/motion/path_samples.h"
#include "tests/support/cycle.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

using stanok::testing::cycle_s;

// A chain of lines with random lengths, feeds and, now and then, stricter limits and rapid travel.
ChainMaker random_chain(std::mt19937_64& random, int count, double length_exponent) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  ChainMaker chain(usual_limits);
  for (int k = 0; k < count; ++k) {
    const double length = std::pow(10.0, 3.0 * part(random) + length_exponent);
    const double feed = 5.0 + 195.0 * part(random);
    const double kind = part(random);
    if (kind < 0.3) {
      chain.slow_line(length, feed,
                      {.v = 20.0 + 380.0 * part(random),
                       .a = 300.0 + 1700.0 * part(random),
                       .j = 5e3 + 4.5e4 * part(random)});
    } else {
      chain.line(length, feed);
      if (kind > 0.85) chain.as_rapid();
    }
    if (part(random) < 0.05) chain.end_chain();
  }
  chain.end_chain();
  return chain;
}

// Settings that change at random cycles.
class RandomOperator {
 public:
  RandomOperator(unsigned seed, double changes_per_cycle)
      : random_(seed), changes_per_cycle_(changes_per_cycle) {}
  FeedControl operator()(int) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    if (part(random_) < changes_per_cycle_) {
      control_.hold = part(random_) < 0.25;
      control_.feed_override = part(random_) < 0.3 ? 1.0 : 2.0 * part(random_);
      control_.rapid_override = part(random_) < 0.3 ? 1.0 : part(random_);
      if (part(random_) < 0.05) control_.feed_override = 0.0;
    }
    return control_;
  }

 private:
  std::mt19937_64 random_;
  double changes_per_cycle_;
  FeedControl control_;
};

struct OverrideScene {
  const char* name;
  int segments;
  double length_exponent;  // lengths 10^e ... 10^(e + 3) mm
  double changes_per_cycle;
};

class OverrideScenes : public ::testing::TestWithParam<OverrideScene> {};

TEST_P(OverrideScenes, LimitsHoldAndTheEndIsExactWhateverTheOperatorDoes) {
  const OverrideScene& scene = GetParam();
  for (unsigned seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(::testing::Message() << scene.name << " seed " << seed);
    std::mt19937_64 random(seed);
    const ChainMaker chain = random_chain(random, scene.segments, scene.length_exponent);
    RandomOperator settings(seed, scene.changes_per_cycle);
    int cycles = 0;
    const auto samples = run_path(three_axes(usual_limits), chain.built(), [&](int k) {
      ++cycles;
      return k < 20000 ? settings(k) : FeedControl{};  // let it finish in the end
    });
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, cycle_s).worst(), 1.000001);
    EXPECT_LE(columns_of(samples, 0, usual_limits).worst(), 1.000001);
    EXPECT_EQ(samples.back().out.state, PathState::idle);
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
    EXPECT_NEAR(samples.back().s, chain.length(), 1e-8 * chain.length());
    for (std::size_t k = 1; k < samples.size(); ++k) {
      ASSERT_GE(samples[k].out.path_advanced, 0.0);
      ASSERT_GE(samples[k].out.s_speed, 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, OverrideScenes,
                         ::testing::Values(OverrideScene{"dense", 400, -2.5, 0.01},
                                           OverrideScene{"long", 40, -1.0, 0.003},
                                           OverrideScene{"nervous", 100, -1.5, 0.2},
                                           OverrideScene{"tiny", 600, -4.0, 0.05}),
                         [](const auto& scene) { return scene.param.name; });

// Each segment's own speed, acceleration and jerk along s, not only those of the axis.
TEST(Override, SegmentLimitsHoldAboveOneHundredPercent) {
  int used = 0;  // runs that came above the programmed feed
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    std::vector<double> ends, speeds, accelerations, jerks;
    double length = 0.0;
    for (int k = 0; k < 60; ++k) {
      const Limits own{.v = 20.0 + 200.0 * part(random),
                       .a = 300.0 + 1700.0 * part(random),
                       .j = 5e3 + 4.5e4 * part(random)};
      const double segment = std::pow(10.0, 2.5 * part(random) - 0.5);
      chain.slow_line(segment, 80.0, own);
      length += segment;
      ends.push_back(length);
      speeds.push_back(std::min(own.v, 1.7 * 80.0));
      accelerations.push_back(own.a);
      jerks.push_back(own.j);
    }
    chain.end_chain();
    const auto samples = run_path(three_axes(usual_limits), chain.built(), [](int k) {
      return FeedControl{.feed_override = k < 100 ? 1.0 : 1.7};
    });
    double top = 0.0;
    for (const Sample& sample : samples) {
      const auto at = std::upper_bound(ends.begin(), ends.end(), sample.s) - ends.begin();
      const auto segment = std::min<std::size_t>(static_cast<std::size_t>(at), ends.size() - 1);
      const auto& x = sample.out.axes[0];
      EXPECT_LE(x.first, speeds[segment] * (1.0 + 1e-8));
      EXPECT_LE(std::abs(x.second), accelerations[segment] * (1.0 + 1e-8));
      EXPECT_LE(std::abs(x.third), jerks[segment] * (1.0 + 1e-8));
      top = std::max(top, x.first);
    }
    used += top > 80.5 ? 1 : 0;
  }
  EXPECT_GE(used, 10);
}

// Lines with limits of their own, which differ little: the brake at the end of the path, which is
// made softer to end there exactly, may begin while the motion speeds up still.
TEST(Override, SpeedsHoldWhereABrakeIsMadeToEndAtTheEndOfThePath) {
  for (unsigned seed = 1; seed <= stanok::testing::cases(2000U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    const double v = 50.0 + 200.0 * part(random);
    // Up to the highest speed and down again takes v (v / A + A / J).
    const double length =
        (0.95 + 0.1 * part(random)) * v * (v / usual_limits.a + usual_limits.a / usual_limits.j);
    constexpr int lines = 8;
    std::vector<double> ends, speeds;
    for (int k = 0; k < lines; ++k) {
      const Limits own{.v = v * (1.0 + 0.01 * part(random)),
                       .j = usual_limits.j * (0.95 + 0.05 * part(random))};
      chain.slow_line(length / lines, 500.0, own);
      ends.push_back(length * (k + 1) / lines);
      speeds.push_back(own.v);
    }
    chain.end_chain();
    const auto samples = run_path(three_axes(usual_limits), chain.built(), [](int k) {
      return k < 2 ? FeedControl{} : FeedControl{.controlled_per_s = 100.0};  // of no axis here
    });
    for (const Sample& sample : samples) {
      const auto at = std::upper_bound(ends.begin(), ends.end(), sample.s) - ends.begin();
      const double cap = speeds[std::min<std::size_t>(static_cast<std::size_t>(at), lines - 1)];
      ASSERT_LE(sample.out.axes[0].first, cap * (1.0 + 1e-8)) << sample.s;
    }
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
  }
}

// Blends of some tens of nm between lines: a cycle passes several segments, the limits of each hold
// at its setpoints.
TEST(Override, SegmentLimitsHoldWhereACyclePassesSeveralSegments) {
  for (unsigned seed = 1; seed <= stanok::testing::cases(200U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    std::vector<double> ends;
    std::vector<Limits> own;
    double length = 0.0;
    for (int k = 0; k < 30; ++k) {
      const bool is_blend = k % 2 == 1;
      own.push_back(is_blend ? Limits{.v = 0.02 + 0.5 * part(random),
                                      .a = 10.0 + 100.0 * part(random),
                                      .j = 5e3 + 5e3 * part(random)}
                             : usual_limits);
      const double segment = std::pow(10.0, (is_blend ? -5.0 : -4.5) + 1.5 * part(random));
      chain.slow_line(segment, 80.0, own.back());
      length += segment;
      ends.push_back(length);
    }
    chain.end_chain();
    RandomOperator settings(seed, 0.05);
    const auto samples = run_path(three_axes(usual_limits), chain.built(), [&](int k) {
      return k < 5000 ? settings(k) : FeedControl{.feed_override = 0.5};
    });
    for (const Sample& sample : samples) {
      const auto at = std::upper_bound(ends.begin(), ends.end(), sample.s) - ends.begin();
      const Limits& limits = own[std::min<std::size_t>(static_cast<std::size_t>(at), 29)];
      const auto& x = sample.out.axes[0];
      EXPECT_LE(x.first, limits.v * (1.0 + 1e-8));
      EXPECT_LE(std::abs(x.second), limits.a * (1.0 + 1e-8));
      EXPECT_LE(std::abs(x.third), limits.j * (1.0 + 1e-8));
    }
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
  }
}

TEST(Override, SteadySpeedIsExactlyTheOverriddenFeed) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 30; ++k) chain.line(10.0, 60.0);
  chain.end_chain();
  for (const double part : {0.1, 0.37, 0.999, 1.2, 2.0}) {
    const auto samples = run_path(three_axes(usual_limits), chain.built(),
                                  [&](int) { return FeedControl{.feed_override = part}; });
    const auto steady = std::count_if(samples.begin(), samples.end(), [&](const Sample& sample) {
      return sample.out.s_speed == part * 60.0;
    });
    const double seconds = chain.length() / (part * 60.0);
    EXPECT_GT(static_cast<double>(steady), 0.85 * seconds / cycle_s);
  }
}

TEST(Override, HoldBeginsToBrakeAtOnceAndStandsUntilResumed) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 200; ++k) chain.line(1.0, 100.0 + 20.0 * (k % 3));
  chain.end_chain();
  for (int at = 5; at < 900; at += 37) {
    SCOPED_TRACE(::testing::Message() << "hold in cycle " << at);
    const auto samples = run_path(three_axes(usual_limits), chain.built(), [&](int k) {
      return FeedControl{.hold = k >= at && k < at + 400};
    });
    // At constant speed or speeding up: jerk turns against the motion in the first cycle.
    const auto& before = samples[static_cast<std::size_t>(at)].out;
    const auto& after = samples[static_cast<std::size_t>(at) + 2].out;
    EXPECT_LT(after.axes[0].second, std::max(before.axes[0].second, 1e-9));
    const auto& held = samples[static_cast<std::size_t>(at) + 350].out;
    EXPECT_EQ(held.state, PathState::holding);
    EXPECT_EQ(held.axes[0].first, 0.0);
    EXPECT_EQ(samples[static_cast<std::size_t>(at) + 399].out.axes[0].value, held.axes[0].value);
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, cycle_s).worst(), 1.000001);
  }
}

TEST(Override, BrakesAsFastAsTheLimitsAllow) {
  ChainMaker chain(usual_limits);
  chain.line(500.0, 300.0).end_chain();
  const auto samples = run_path(
      three_axes(usual_limits), chain.built(), [](int k) { return FeedControl{.hold = k >= 800}; },
      2000);
  // From 300 mm/s: T = A / J + v / A = 0.04 + 0.15 s.
  int braking = 0;
  for (std::size_t k = 801; k < samples.size() && samples[k].out.s_speed > 0.0; ++k) ++braking;
  EXPECT_NEAR(braking, 190, 2);
}

TEST(Override, ZeroStandsStill) {
  ChainMaker chain(usual_limits);
  chain.line(100.0, 50.0).end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built(), [](int k) {
    return FeedControl{.feed_override = k < 300 || k >= 900 ? 1.0 : 0.0};
  });
  EXPECT_EQ(samples[800].out.state, PathState::holding);
  EXPECT_EQ(samples[800].out.s_speed, 0.0);
  EXPECT_EQ(samples.back().out.axes[0].value, 100.0);
}

TEST(Override, BackAtOneHundredPercentCostsLittleTime) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 100; ++k) chain.line(5.0, 100.0).line(0.05, 30.0);
  chain.end_chain();
  const auto nominal = run_path(three_axes(usual_limits), chain.built());
  // One change in the beginning: nearly everything is then run by the planner in the cycle.
  const auto planned = run_path(three_axes(usual_limits), chain.built(), [](int k) {
    return FeedControl{.feed_override = k == 20 ? 0.9 : 1.0};
  });
  EXPECT_LT(static_cast<double>(planned.size()), 1.05 * static_cast<double>(nominal.size()));
}

TEST(Override, ComesToRestAtTheEndOfWhatArrivedAndGoesOnWhenMoreDoes) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 8000; ++k) chain.line(0.1, 100.0);
  chain.end_chain();
  const MotionConfig config = three_axes(usual_limits);
  LookAhead look_ahead(config);
  for (const auto& built : chain.built()) look_ahead.add(built);
  PathQueue prepared;
  ASSERT_TRUE(look_ahead.deliver(prepared));
  ASSERT_GT(prepared.chunks.size(), 3U);
  PathQueue queue;
  double arrived = 0.0;
  const auto deliver_one = [&] {
    const Chunk chunk = prepared.chunks.front();
    for (std::uint32_t k = 0; k < chunk.segments; ++k)
      ASSERT_TRUE(queue.segments.push(prepared.segments[k]));
    for (std::uint32_t k = 0; k < chunk.phases; ++k)
      ASSERT_TRUE(queue.phases.push(prepared.phases[k]));
    ASSERT_TRUE(queue.chunks.push(chunk));
    prepared.segments.pop_front(chunk.segments);
    prepared.phases.pop_front(chunk.phases);
    prepared.chunks.pop_front();
    arrived += chunk.length;
  };
  deliver_one();
  Interpolator interpolator(config);
  std::vector<Sample> samples(1);
  const auto run = [&](int cycles) {
    for (int k = 0; k < cycles; ++k) {
      Sample sample;
      interpolator.advance(queue, {}, sample.out);
      samples.push_back(sample);
    }
  };
  run(10);
  EXPECT_EQ(samples.back().out.state, PathState::idle);  // one chunk alone is not entered
  deliver_one();
  run(5000);
  EXPECT_EQ(samples.back().out.state, PathState::starved);
  EXPECT_EQ(samples.back().out.s_speed, 0.0);
  EXPECT_NEAR(samples.back().out.axes[0].value, arrived, 1e-9);
  while (!prepared.chunks.empty()) deliver_one();
  run(15000);
  EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
  EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, cycle_s).worst(), 1.000001);
}

TEST(Override, LimitsHoldAcrossChunks) {
  ChainMaker chain(usual_limits);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 9000; ++k)
    chain.line(0.02 + 0.1 * part(random), k % 500 < 250 ? 60.0 : 110.0);
  chain.end_chain();
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    RandomOperator settings(seed, 0.004);
    const auto samples = run_path(three_axes(usual_limits), chain.built(),
                                  [&](int k) { return k < 30000 ? settings(k) : FeedControl{}; });
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, cycle_s).worst(), 1.000001);
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
    EXPECT_NEAR(samples.back().s, chain.length(), 1e-9 * chain.length());
  }
}

TEST(Override, CycleUsesNoHeap) {
  std::mt19937_64 random(5);
  const ChainMaker chain = random_chain(random, 300, -2.5);
  const MotionConfig config = three_axes(usual_limits);
  PathQueue queue;
  LookAhead look_ahead(config);
  for (const auto& built : chain.built()) look_ahead.add(built);
  ASSERT_TRUE(look_ahead.deliver(queue));
  Interpolator interpolator(config);
  InterpolatorOutput out;
  RandomOperator settings(5, 0.02);
  const stanok::testing::NoAllocation guard;
  for (int k = 0; k < 5000; ++k) interpolator.advance(queue, settings(k), out);
}

}  // namespace
}  // namespace stanok::motion::testing
