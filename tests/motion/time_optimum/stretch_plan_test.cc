// Plans of single stretches against closed forms and against densely sampled axes.
#include "motion/time_optimum/stretch_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/bounds/segment_bounds.h"
#include "motion/path/geometry.h"
#include "motion/time_optimum/path_index.h"
#include "motion/time_optimum/phase_list.h"
#include "tests/motion/path_samples.h"

namespace stanok::motion::testing {
namespace {

constexpr Limits stretch_limits{.v = 1000.0, .a = 2000.0, .j = 50000.0};

// Segments and a slow plan along them: from rest to rest under a twentieth of the stretch_limits.
struct SlowPath {
  explicit SlowPath(std::vector<Segment> all) : segments(std::move(all)) {
    index.reset(segments);
    length = index.start(segments.size());
    const RampLimits slow{.a = stretch_limits.a / 20.0, .j = stretch_limits.j / 20.0};
    const double top = peak_speed(0.0, 0.0, length, slow, slow, stretch_limits.v);
    for (const Phase& phase : ramp_up(0.0, 0.0, top, slow)) phases.push_back(phase);
    const PhaseRun down = ramp_down(top, length, 0.0, slow);
    const double s = phases.back().s_end;
    if (down[0].s > s) {
      phases.push_back(
          {.duration = (down[0].s - s) / top, .s = s, .v = top, .s_end = down[0].s, .v_end = top});
    }
    for (const Phase& phase : down) phases.push_back(phase);
  }
  [[nodiscard]] Stretch stretch() const {
    return {.segments = segments,
            .jerk_parts = jerk_parts,
            .index = &index,
            .phases = phases,
            .s0 = 0.0,
            .s1 = length};
  }

  std::vector<Segment> segments;
  std::vector<double> jerk_parts = std::vector<double>(segments.size(), 1.0);
  PathIndex index;
  double length = 0.0;
  std::vector<Phase> phases;
};

std::vector<Segment> segments_of(ChainMaker& chain) {
  std::vector<Segment> segments;
  for (const auto& built : chain.built()) segments.push_back(built.segment);
  return segments;
}

void expect_joined(std::span<const Phase> phases, double s0, double s1) {
  ASSERT_FALSE(phases.empty());
  EXPECT_EQ(phases.front().s, s0);
  EXPECT_EQ(phases.back().s_end, s1);
  for (std::size_t k = 1; k < phases.size(); ++k) {
    const PathMotion end = motion_at(phases[k - 1], phases[k - 1].duration);
    EXPECT_NEAR(phases[k].s, end.s, 1e-9);
    EXPECT_NEAR(phases[k].v, end.v, 1e-9 * stretch_limits.v);
    EXPECT_NEAR(phases[k].a, end.a, 1e-9 * stretch_limits.a);
  }
}

// From rest to rest along X: the fastest ramps are known (motion/profile/profile.h).
TEST(StretchPlan, AStraightLineTakesTheTimeOfItsFastestRamps) {
  for (const double length : {0.5, 5.0, 50.0}) {
    SCOPED_TRACE(length);
    ChainMaker chain(stretch_limits);
    chain.line(length, stretch_limits.v);
    const SlowPath path(segments_of(chain));
    StretchPlan plan(three_axes(stretch_limits));
    const auto phases = plan.plan(path.stretch());
    expect_joined(phases, 0.0, length);
    const RampLimits ramp{.a = stretch_limits.a, .j = stretch_limits.j};
    const double top = peak_speed(0.0, 0.0, length, ramp, ramp, stretch_limits.v);
    const double held = length - 2.0 * ramp_distance(0.0, top, ramp);
    const double shortest = 2.0 * ramp_duration(0.0, top, ramp) + held / top;
    EXPECT_GE(duration_of(phases), shortest * (1.0 - 1e-9));
    EXPECT_LE(duration_of(phases), 1.03 * shortest + 0.006);  // and two intervals
  }
}

// Every axis by the closed form of a circle, at times that the plan does not know of.
TEST(StretchPlan, AnArcKeepsTheLimitsOfItsAxesEverywhere) {
  constexpr double radius = 12.0;
  ChainMaker chain(stretch_limits);
  chain.arc(radius, 5.0, stretch_limits.v);
  const SlowPath path(segments_of(chain));
  StretchPlan plan(three_axes(stretch_limits));
  const auto phases = plan.plan(path.stretch());
  expect_joined(phases, 0.0, 5.0 * radius);
  double used = 0.0;
  for (const Phase& phase : phases) {
    for (int k = 0; k <= 20; ++k) {
      const PathMotion m = motion_at(phase, 0.05 * k * phase.duration);
      const double w = m.s / radius;
      // Along the tangent and across it, then by axis.
      const double a_t = m.a;
      const double a_n = m.v * m.v / radius;
      const double j_t = m.j - m.v * m.v * m.v / (radius * radius);
      const double j_n = 3.0 * m.v * m.a / radius;
      const double c = std::cos(w);
      const double s = std::sin(w);
      for (const double a : {a_t * s + a_n * c, a_t * c - a_n * s})
        used = std::max(used, std::abs(a) / stretch_limits.a);
      for (const double j : {j_t * s + j_n * c, j_t * c - j_n * s})
        used = std::max(used, std::abs(j) / stretch_limits.j);
    }
  }
  EXPECT_LE(used, 1.0);
  EXPECT_GT(used, 0.9);
}

TEST(StretchPlan, WhatIsFastAlreadyStays) {
  ChainMaker chain(stretch_limits);
  chain.line(30.0, stretch_limits.v);
  SlowPath path(segments_of(chain));
  const RampLimits ramp{.a = stretch_limits.a, .j = stretch_limits.j};
  const double top = peak_speed(0.0, 0.0, path.length, ramp, ramp, stretch_limits.v);
  path.phases.clear();
  for (const Phase& phase : ramp_up(0.0, 0.0, top, ramp)) path.phases.push_back(phase);
  for (const Phase& phase : ramp_down(top, path.length, 0.0, ramp)) path.phases.push_back(phase);
  StretchPlan plan(three_axes(stretch_limits));
  EXPECT_TRUE(plan.plan(path.stretch()).empty());
}

// Intervals of 3 ms over hours.
TEST(StretchPlan, WhatIsPassedVerySlowlyStays) {
  ChainMaker chain({.v = 1e-4, .a = stretch_limits.a, .j = stretch_limits.j});
  chain.arc(5.0, 1.0, 100.0);
  const SlowPath path(segments_of(chain));
  StretchPlan plan(three_axes(stretch_limits));
  EXPECT_TRUE(plan.plan(path.stretch()).empty());
}

TEST(PathIndex, FindsTheSegmentsBesideAPlace) {
  ChainMaker chain(stretch_limits);
  chain.line(1.0, 10.0).line(2.0, 10.0).line(3.0, 10.0);
  const auto segments = segments_of(chain);
  PathIndex index;
  index.reset(segments);
  EXPECT_EQ(index.start(3), 6.0);
  EXPECT_EQ(index.at(0.0), 0U);
  EXPECT_EQ(index.at(1.0), 1U);
  EXPECT_EQ(index.before(1.0), 0U);
  EXPECT_EQ(index.before(1.5), 1U);
  EXPECT_EQ(index.at(6.0), 2U);
  EXPECT_EQ(index.before(6.0), 2U);
  EXPECT_EQ(index.at(7.0), 2U);
  EXPECT_EQ(index.before(0.0), 0U);
}

TEST(PhaseList, CutsPhasesAtBothPlaces) {
  const RampLimits ramp{.a = stretch_limits.a, .j = stretch_limits.j};
  std::vector<Phase> phases;
  for (const Phase& phase : ramp_up(0.0, 10.0, 300.0, ramp)) phases.push_back(phase);
  const double end = phases.back().s_end;
  std::vector<Phase> parts;
  append_between(phases, 0.0, 0.3 * end, parts);
  append_between(phases, 0.3 * end, end, parts);
  EXPECT_NEAR(duration_of(parts), duration_of(phases), 1e-12);
  PhaseWalk walk(phases);
  for (const Phase& part : parts) EXPECT_NEAR(walk.at(part.s).v, part.v, 1e-9);
}

}  // namespace
}  // namespace stanok::motion::testing
