// The nominal run from segments to setpoints: limits, ends, steady speed, chains within a cycle.
#include "motion/interpolation/interpolator.h"

#include <gtest/gtest.h>

#include "tests/motion/path_samples.h"
#include "tests/support/no_allocation.h"

namespace stanok::motion::testing {
namespace {

TEST(Interpolator, ShortMoveTakesTheTimeOfTheClosedForm) {
  // 10 mm at 50 mm/s: T = L / F + ramp time / 2 * 2 = 10 / 50 + 2 sqrt(50 / 50000).
  ChainMaker chain(usual_limits);
  chain.line(10.0, 50.0).end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built());
  const double expected = 10.0 / 50.0 + 2.0 * std::sqrt(50.0 / 50000.0);
  EXPECT_EQ(static_cast<int>(samples.size()) - 1, static_cast<int>(std::ceil(expected / 0.001)));
  EXPECT_EQ(samples.back().out.axes[0].value, 10.0);
  EXPECT_EQ(samples.back().out.axes[0].first, 0.0);
}

TEST(Interpolator, SteadyPartRunsAtExactlyTheProgrammedFeed) {
  ChainMaker chain(usual_limits);
  chain.line(3.3, 100.0).line(4.7, 100.0).line(11.1, 100.0).end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built());
  int steady = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    if (samples[k].out.s_speed == 100.0) ++steady;
    EXPECT_LE(samples[k].out.s_speed, 100.0);
  }
  EXPECT_GT(steady, 80);  // of 191 ms the ramps of 2 * (0.04 + 0.05) s are the rest
}

TEST(Interpolator, LimitsHoldOnRandomChainsAndTheEndIsExact) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    const int count = 1 + static_cast<int>(40.0 * part(random));
    for (int k = 0; k < count; ++k) {
      const double length = std::pow(10.0, 4.0 * part(random) - 2.5);
      const double feed = 5.0 + 395.0 * part(random);
      if (part(random) < 0.3) {
        chain.slow_line(
            length, feed,
            {.v = 400.0, .a = 300.0 + 1700.0 * part(random), .j = 5e3 + 4.5e4 * part(random)});
      } else {
        chain.line(length, feed);
      }
    }
    chain.end_chain();
    const auto samples = run_path(three_axes(usual_limits), chain.built());
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, 0.001).worst(), 1.000001);
    EXPECT_LE(columns_of(samples, 0, usual_limits).worst(), 1.000001);
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
    EXPECT_EQ(samples.back().out.axes[0].first, 0.0);
    EXPECT_NEAR(samples.back().s, chain.length(), 1e-9 * chain.length());
  }
}

TEST(Interpolator, SegmentSpeedsAreKeptEverywhere) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    double feed = 100.0;
    for (int k = 0; k < 300; ++k) {  // dense: several segments a cycle
      feed = std::clamp(feed * (0.8 + 0.45 * part(random)), 2.0, 400.0);
      chain.line(0.02 + 0.2 * part(random), feed);
    }
    chain.end_chain();
    const auto samples = run_path(three_axes(usual_limits), chain.built());
    for (const Sample& sample : samples) {
      if (sample.out.state != PathState::moving) continue;
      EXPECT_LE(sample.out.s_speed, sample.out.feed_commanded * (1.0 + 1e-9));
    }
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, 0.001).worst(), 1.000001);
  }
}

TEST(Interpolator, ChainsFollowEachOtherWithoutLosingTheFractionOfACycle) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 20; ++k) chain.line(0.37, 60.0).end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built());
  // Each chain: the peak v with D(0, v) + D(v, 0) = v * 2 sqrt(v / J) = 0.37, T = 4 sqrt(v / J).
  const double v = std::cbrt(0.37 * 0.37 / 4.0 * 50000.0);
  const double expected = 20.0 * 4.0 * std::sqrt(v / 50000.0);
  EXPECT_EQ(static_cast<int>(samples.size()) - 1, static_cast<int>(std::ceil(expected / 0.001)));
  EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, 0.001).worst(), 1.000001);
  EXPECT_EQ(samples.back().out.chunks_done, 20U);
}

TEST(Interpolator, ChainBeyondTheChunkLimitIsNotEntered) {
  ChainMaker chain(usual_limits);
  chain.line(1.0, 60.0).end_chain().line(1.0, 60.0).end_chain();
  const MotionConfig config = three_axes(usual_limits);
  PathQueue queue;
  LookAhead look_ahead(config);
  for (const auto& built : chain.built()) look_ahead.add(built);
  ASSERT_TRUE(look_ahead.deliver(queue));
  Interpolator interpolator(config);
  InterpolatorOutput out;
  bool ended = false;
  for (int k = 0; k < 1000; ++k) {
    interpolator.advance(queue, {}, out, 1);
    ended = ended || out.chain_ended;
  }
  EXPECT_TRUE(ended);
  EXPECT_EQ(out.chunks_done, 1U);
  EXPECT_EQ(out.axes[0].value, 1.0);
  for (int k = 0; k < 1000; ++k) interpolator.advance(queue, {}, out, 2);
  EXPECT_EQ(out.axes[0].value, 2.0);
}

TEST(Interpolator, CycleUsesNoHeap) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 500; ++k) chain.line(0.1, 50.0 + 50.0 * (k % 7));
  chain.end_chain();
  const MotionConfig config = three_axes(usual_limits);
  PathQueue queue;
  LookAhead look_ahead(config);
  for (const auto& built : chain.built()) look_ahead.add(built);
  ASSERT_TRUE(look_ahead.deliver(queue));
  Interpolator interpolator(config);
  InterpolatorOutput out;
  const stanok::testing::NoAllocation guard;
  do {
    interpolator.advance(queue, {}, out);
  } while (out.state == PathState::moving);
}

TEST(Interpolator, DroppedPathLeavesTheAxesWhereTheyStand) {
  ChainMaker chain(usual_limits);
  chain.line(50.0, 60.0).end_chain().line(50.0, 60.0).end_chain();
  const MotionConfig config = three_axes(usual_limits);
  PathQueue queue;
  LookAhead look_ahead(config);
  for (const auto& built : chain.built()) look_ahead.add(built);
  ASSERT_TRUE(look_ahead.deliver(queue));
  Interpolator interpolator(config);
  InterpolatorOutput out;
  for (int k = 0; k < 300; ++k) interpolator.advance(queue, {}, out);
  while (!interpolator.at_rest()) interpolator.advance(queue, {.hold = true}, out);
  const double stopped_at = out.axes[0].value;
  interpolator.drop_path(queue);
  EXPECT_TRUE(queue.segments.empty());
  EXPECT_TRUE(queue.phases.empty());
  interpolator.advance(queue, {}, out);
  EXPECT_EQ(out.state, PathState::idle);
  EXPECT_EQ(out.axes[0].value, stopped_at);
  EXPECT_EQ(out.chunks_done, 2U);
}

TEST(Interpolator, StandsWhereItIsTold) {
  Interpolator interpolator(three_axes(usual_limits));
  kinematics::Transform transform;
  transform.frame.offset = {10.0, 0.0, -5.0};
  interpolator.stand_at({1.0, 2.0, 3.0}, transform);
  PathQueue queue;
  InterpolatorOutput out;
  interpolator.advance(queue, {}, out);
  EXPECT_EQ(out.state, PathState::idle);
  EXPECT_EQ(out.axes[1].value, 2.0);
  EXPECT_TRUE(interpolator.at_rest());
}

}  // namespace
}  // namespace stanok::motion::testing
