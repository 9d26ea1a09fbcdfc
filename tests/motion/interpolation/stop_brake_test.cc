// The brake of a plan by signed terms of each axis: limits, rest, a release from everywhere, and
// bounded work.
#include "motion/interpolation/stop_brake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/path_fixture.h"
#include "tests/motion/path_samples.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

constexpr double stop_limits_used = 1.2;
constexpr double stop_cycle = 0.001;

MotionConfig with_stops(const Limits& limits, double cycle_s = stop_cycle) {
  MotionConfig config = three_axes(limits, cycle_s);
  for (int k = 0; k < config.axis_count; ++k) config.axes[k].stop_limits = stop_limits_used;
  return config;
}

// A plan that passes one segment at one speed.
struct EvenPlan {
  EvenPlan(const ChainMaker& chain, double speed) : v(speed) {
    const Segment& segment = chain.built().front().segment;
    EXPECT_TRUE(queue.segments.push(segment));
    EXPECT_TRUE(queue.phases.push(
        {.duration = segment.length / speed, .v = speed, .s_end = segment.length, .v_end = speed}));
    EXPECT_TRUE(
        queue.chunks.push({.segments = 1, .phases = 1, .last = true, .length = segment.length}));
    cursor.enter(queue);
  }
  double v;
  PathQueue queue;
  PathCursor cursor;
};

// The largest use of the stop limits within a step on a circle; `time` of the plan at its start.
double use_on_circle(const PaceStep& step, double time, double v, double radius,
                     const Limits& limits, double step_s) {
  double use = 0.0;
  constexpr int instants = 8;
  for (int k = 0; k <= instants; ++k) {
    const double t = step_s * k / instants;
    const Pace pace = step.after(t);
    const double advanced =
        t * (step.from.rate + t * (0.5 * step.from.change + t * step.second / 6.0));
    const PathMotion m = at_pace({.s = v * (time + advanced), .v = v}, pace, step.second);
    const double w = m.s / radius;
    const double a_n = m.v * m.v / radius;
    const double j_t = m.j - m.v * m.v * m.v / (radius * radius);
    const double j_n = 3.0 * m.v * m.a / radius;
    const double c = std::cos(w);
    const double s = std::sin(w);
    for (const double a : {m.a * s + a_n * c, m.a * c - a_n * s})
      use = std::max(use, std::abs(a) / (stop_limits_used * limits.a));
    for (const double j : {j_t * s + j_n * c, j_t * c - j_n * s})
      use = std::max(use, std::abs(j) / (stop_limits_used * limits.j));
  }
  return use;
}

// v / A + A / J, of which the brake keeps a reserve; its steps are whole cycles.
TEST(StopBrake, BrakesAStraightLineAsFastAsItsLimitsAllow) {
  const double v = 100.0;
  ChainMaker chain(usual_limits);
  chain.line(50.0, v);
  for (const double cycle_s : {0.00025, 0.001, 0.004}) {
    SCOPED_TRACE(cycle_s);
    const EvenPlan plan(chain, v);
    StopBrake brake(with_stops(usual_limits, cycle_s));
    ASSERT_TRUE(brake.begin(plan.queue, plan.cursor, 0.0, {}));
    Pace pace;
    double elapsed = 0.0;
    int cycles = 0;
    for (; !pace.rests() && cycles * cycle_s < 1.0; ++cycles) {
      const PaceStep step = brake.brake(plan.queue, plan.cursor, elapsed, pace);
      ASSERT_LE(step.to.rate, pace.rate);
      elapsed += step.advance;
      pace = step.to;
    }
    const double a = stop_limits_used * usual_limits.a;
    const double j = stop_limits_used * usual_limits.j;
    const double least = v / a + a / j;
    EXPECT_GE(cycles * cycle_s, least - cycle_s);
    EXPECT_LE(cycles * cycle_s, 1.03 * least + 4.0 * std::max(cycle_s, 0.001));
  }
}

// At the speed at which an axis has all of its acceleration at its turning point, from every place
// of a circle.
TEST(StopBrake, KeepsTheLimitsOfAxesThatThePlanUsesToTheFull) {
  constexpr double radius = 10.0;
  const Limits limits{.v = 1000.0, .a = 2000.0, .j = 80000.0};
  const double v =
      0.99 * std::min(std::sqrt(limits.a * radius), std::cbrt(limits.j * radius * radius));
  ChainMaker chain(limits);
  chain.arc(radius, 12.0, v);
  const EvenPlan plan(chain, v);
  StopBrake brake(with_stops(limits));
  for (int place = 0; place < stanok::testing::cases(200); ++place) {
    SCOPED_TRACE(place);
    double elapsed = 0.0021 * place;
    Pace pace;
    ASSERT_TRUE(brake.begin(plan.queue, plan.cursor, elapsed, pace));
    int cycles = 0;
    for (; !pace.rests() && cycles < 400; ++cycles) {
      const PaceStep step = brake.brake(plan.queue, plan.cursor, elapsed, pace);
      ASSERT_LE(use_on_circle(step, elapsed, v, radius, limits, stop_cycle), 1.0);
      ASSERT_LE(step.to.rate, pace.rate);
      elapsed += step.advance;
      pace = step.to;
    }
    EXPECT_LT(cycles, 250);
  }
}

// From everywhere on the way to rest, also from paces that change when the stop begins.
TEST(StopBrake, ReleasesFromEverywhere) {
  constexpr double radius = 15.0;
  const Limits limits{.v = 1000.0, .a = 2000.0, .j = 60000.0};
  const double v =
      0.95 * std::min(std::sqrt(limits.a * radius), std::cbrt(limits.j * radius * radius));
  ChainMaker chain(limits);
  chain.arc(radius, 12.0, v);
  const EvenPlan plan(chain, v);
  StopBrake brake(with_stops(limits));
  int begun = 0;
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(400U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    double elapsed = random.between(0.0, 0.4);
    Pace pace;
    if (random.chance(0.5))
      pace = {.rate = random.between(0.1, 0.95), .change = random.between(-8.0, 3.0)};
    if (!brake.begin(plan.queue, plan.cursor, elapsed, pace)) {
      EXPECT_FALSE(pace.is_nominal());
      continue;
    }
    ++begun;
    const auto braked = static_cast<int>(random.between(0.0, 120.0));
    for (int k = 0; k < 400 && !pace.rests() && (k < braked || pace.change != 0.0); ++k) {
      const PaceStep step = k < braked ? brake.brake(plan.queue, plan.cursor, elapsed, pace)
                                       : brake.release(plan.queue, plan.cursor, elapsed, pace);
      ASSERT_LE(use_on_circle(step, elapsed, v, radius, limits, stop_cycle), 1.0) << "cycle " << k;
      ASSERT_GE(step.to.rate, 0.0);
      elapsed += step.advance;
      pace = step.to;
    }
    EXPECT_EQ(pace.change, 0.0);
  }
  EXPECT_GT(begun, static_cast<int>(stanok::testing::cases(400U)) / 2);
}

TEST(StopBrake, WorksABoundedTimeWithoutHeap) {
  constexpr double radius = 8.0;
  const Limits limits{.v = 1000.0, .a = 2500.0, .j = 50000.0};
  const double v = 100.0;
  ChainMaker chain(limits);
  chain.arc(radius, 12.0, v);
  const EvenPlan plan(chain, v);
  StopBrake brake(with_stops(limits));
  const stanok::testing::NoAllocation guard;
  Pace pace;
  double elapsed = 0.1;
  ASSERT_TRUE(brake.begin(plan.queue, plan.cursor, elapsed, pace));
  for (int k = 0; k < 400 && !pace.rests(); ++k) {
    const PaceStep step = brake.brake(plan.queue, plan.cursor, elapsed, pace);
    ASSERT_LE(brake.steps(), (StopBrake::tries_max + 1) * StopBrake::steps_max);
    ASSERT_LE(brake.evaluations(), PlanTrace::evaluations_max + 2);
    elapsed += step.advance;
    pace = step.to;
  }
  EXPECT_TRUE(pace.rests());
}

}  // namespace
}  // namespace stanok::motion::testing
