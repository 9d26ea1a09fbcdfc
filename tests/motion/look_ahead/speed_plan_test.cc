// Key points, plateaus and stairs: how close to the limits the plan comes, and that it keeps them.
#include "motion/look_ahead/speed_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace stanok::motion {
namespace {

constexpr RampLimits machine{.a = 2000.0, .j = 50000.0};

struct Planned {
  std::vector<Phase> phases;
  double duration = 0.0;
  double length = 0.0;
};

Planned plan(const std::vector<SpeedSegment>& segments) {
  SpeedPlan planner;
  EXPECT_TRUE(planner.plan(segments, 0.0));
  Planned planned;
  for (const KeySpan& span : planner.spans()) planner.append_phases(span, planned.phases);
  for (const Phase& phase : planned.phases) planned.duration += phase.duration;
  planned.length = planner.boundary(segments.size());
  return planned;
}

// Every phase against every segment it touches, sampled closely.
void expect_limits(const std::vector<SpeedSegment>& segments, const Planned& planned) {
  std::size_t segment = 0;
  double end = segments[0].length;
  for (const Phase& phase : planned.phases) {
    constexpr int samples = 40;
    for (int k = 0; k <= samples; ++k) {
      const PathMotion motion = motion_at(phase, phase.duration * k / samples);
      while (segment + 1 < segments.size() && motion.s > end + 1e-9)
        end += segments[++segment].length;
      if (motion.s > end - 1e-9 || motion.s < end - segments[segment].length + 1e-9) continue;
      ASSERT_LE(motion.v, segments[segment].v * (1.0 + 1e-9)) << "segment " << segment;
      ASSERT_LE(std::abs(motion.a), segments[segment].ramp.a * (1.0 + 1e-9))
          << "segment " << segment;
      ASSERT_LE(std::abs(motion.j), segments[segment].ramp.j * (1.0 + 1e-9))
          << "segment " << segment;
    }
  }
}

TEST(SpeedPlan, OneSegmentTakesTheTimeOfTwoRampsAndACruise) {
  const Planned planned = plan({{.length = 100.0, .v = 80.0, .ramp = machine}});
  EXPECT_NEAR(planned.duration, 100.0 / 80.0 + ramp_duration(0.0, 80.0, machine), 1e-12);
}

TEST(SpeedPlan, SegmentsOfOneSpeedAreLikeOne) {
  std::vector<SpeedSegment> many(200, {.length = 0.5, .v = 80.0, .ramp = machine});
  const Planned planned = plan(many);
  EXPECT_NEAR(planned.duration, 100.0 / 80.0 + ramp_duration(0.0, 80.0, machine), 1e-11);
  EXPECT_LE(planned.phases.size(), 7U);
}

TEST(SpeedPlan, SlowSegmentIsPassedAtItsSpeedAndLeftAtOnce) {
  // 50 mm, a slow millimetre, 50 mm: by symmetry two equal halves, each with its own cruise.
  const Planned planned = plan({{.length = 50.0, .v = 100.0, .ramp = machine},
                                {.length = 1.0, .v = 20.0, .ramp = machine},
                                {.length = 50.0, .v = 100.0, .ramp = machine}});
  const double ramps = ramp_distance(0.0, 100.0, machine) + ramp_distance(100.0, 20.0, machine);
  const double half = ramp_duration(0.0, 100.0, machine) + ramp_duration(100.0, 20.0, machine) +
                      (50.0 - ramps) / 100.0;
  EXPECT_NEAR(planned.duration, 2.0 * half + 1.0 / 20.0, 1e-11);
}

TEST(SpeedPlan, PoorLimitsOfASlowSegmentDoNotSpoilTheRampBehindIt) {
  const RampLimits poor{.a = 100.0, .j = 2000.0};
  const Planned planned = plan({{.length = 50.0, .v = 100.0, .ramp = machine},
                                {.length = 0.02, .v = 30.0, .ramp = poor},
                                {.length = 0.02, .v = 20.0, .ramp = poor},
                                {.length = 0.02, .v = 30.0, .ramp = poor},
                                {.length = 50.0, .v = 100.0, .ramp = machine}});
  const double ramps = ramp_distance(0.0, 100.0, machine) + ramp_distance(100.0, 20.0, machine);
  const double half = ramp_duration(0.0, 100.0, machine) + ramp_duration(100.0, 20.0, machine) +
                      (50.0 - ramps) / 100.0;
  EXPECT_LT(planned.duration, 2.0 * half + 0.06 / 20.0 + 1e-9);
}

TEST(SpeedPlan, PoorLimitsNextToRestDoNotSpoilTheRampBehindThem) {
  // At worst: 0.25 mm up to v by the poor limits, D = v^1.5 / sqrt(J), and on from v by the good.
  const RampLimits poor{.a = 100.0, .j = 2000.0};
  const double length = 0.25;
  const double v = std::cbrt(length * length * poor.j);
  const double ramps = ramp_distance(v, 100.0, machine) + ramp_distance(0.0, 100.0, machine);
  const double expected = ramp_duration(0.0, v, poor) + ramp_duration(v, 100.0, machine) +
                          ramp_duration(0.0, 100.0, machine) + (50.0 - ramps) / 100.0;
  std::vector<SpeedSegment> segments{{.length = 0.15, .v = 100.0, .ramp = machine},
                                     {.length = 0.1, .v = 30.0, .ramp = poor},
                                     {.length = 50.0, .v = 100.0, .ramp = machine}};
  EXPECT_LT(plan(segments).duration, expected + 1e-9);
  std::reverse(segments.begin(), segments.end());
  EXPECT_LT(plan(segments).duration, expected + 1e-9);
}

TEST(SpeedPlan, PoorLimitsNextToRestDoNotSpoilARampThatBeginsOnOtherPoorOnes) {
  // At worst: down to w in front of the poor segment by the poorest of the good limits, then to
  // rest.
  const RampLimits poor{.a = 400.0, .j = 1.2e6};
  const RampLimits good{.a = 3000.0, .j = 1.2e6};
  const double w = reachable_speed(0.0, 1.2, poor);
  const double top = peak_speed(0.0, w, 17.0, good, good, 200.0);
  const double held = 17.0 - ramp_distance(0.0, top, good) - ramp_distance(top, w, good);
  const double expected = ramp_duration(0.0, top, good) + held / top + ramp_duration(top, w, good) +
                          ramp_duration(w, 0.0, poor);
  std::vector<SpeedSegment> segments{
      {.length = 8.5, .v = 200.0, .ramp = good},
      {.length = 8.5, .v = 200.0, .ramp = {.a = 3000.0, .j = 2e6}},
      {.length = 0.8, .v = 40.0, .ramp = {.a = 400.0, .j = 1.3e6}},
      {.length = 0.4, .v = 200.0, .ramp = {.a = 2600.0, .j = 1.7e6}}};
  EXPECT_LT(plan(segments).duration, expected + 1e-9);
  std::reverse(segments.begin(), segments.end());
  EXPECT_LT(plan(segments).duration, expected + 1e-9);
}

TEST(SpeedPlan, PathAndItsMirrorImageTakeTheSameTime) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 50; ++k) {
    std::vector<SpeedSegment> segments;
    for (int i = 0; i < 30; ++i) {
      segments.push_back(
          {.length = 0.5 + 5.0 * part(random), .v = 10.0 + 150.0 * part(random), .ramp = machine});
    }
    const double there = plan(segments).duration;
    std::reverse(segments.begin(), segments.end());
    EXPECT_NEAR(plan(segments).duration, there, 0.01 * there);
  }
}

// A limit that rises like v dv/ds = a: against it the plan may lose about a^2 / 2J in speed, twice
// that for what is held between stairs.
TEST(SpeedPlan, SlowlyRisingLimitIsFollowedClosely) {
  for (const double slope : {50.0, 200.0, 500.0}) {
    std::vector<SpeedSegment> segments;
    double ideal = 0.0;
    double ideal_with_loss = 0.0;
    const double loss = slope * slope / machine.j;
    for (int segment = 0; segment < 1200; ++segment) {
      const double s = 0.05 * segment;
      const double v = std::sqrt(900.0 + 2.0 * slope * s);
      segments.push_back({.length = 0.05, .v = v, .ramp = machine});
      ideal += 0.05 / v;
      ideal_with_loss += 0.05 / (v - loss);
    }
    const double v_end = segments.back().v;
    const double start_and_end =
        ramp_duration(0.0, 30.0, machine) + ramp_duration(v_end, 0.0, machine);
    EXPECT_GT(plan(segments).duration, ideal);
    EXPECT_LT(plan(segments).duration, 1.02 * ideal_with_loss + start_and_end) << "slope " << slope;
  }
}

TEST(SpeedPlan, LimitsAreKeptOnRandomRunsOfSegments) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<SpeedSegment> segments;
    const double exponent = -3.0 + 3.0 * part(random);
    double v = 50.0;
    for (int k = 0; k < 120; ++k) {
      v = std::clamp(v * std::exp(part(random) - 0.5), 1.0, 400.0);
      segments.push_back(
          {.length = std::pow(10.0, exponent + part(random)),
           .v = v,
           .ramp = {.a = 100.0 + 2000.0 * part(random), .j = 1000.0 + 50000.0 * part(random)}});
    }
    const Planned planned = plan(segments);
    expect_limits(segments, planned);
    EXPECT_EQ(planned.phases.back().s_end, planned.length);
    EXPECT_EQ(planned.phases.back().v_end, 0.0);
    for (std::size_t k = 1; k < planned.phases.size(); ++k) {
      EXPECT_EQ(planned.phases[k].s, planned.phases[k - 1].s_end);
    }
  }
}

// A key point that was too fast is lowered until the ramp behind it fills its room to the last bit;
// rounding must not make that ramp touch the segment before, whose limits are poorer.
TEST(SpeedPlan, RampsThatFillTheirRoomObeyNoSegmentBesideIt) {
  for (const unsigned seed : {25320U, 33193U, 39447U, 46293U}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<SpeedSegment> segments(4 + static_cast<std::size_t>(20.0 * part(random)));
    for (SpeedSegment& segment : segments) {
      const bool poor = part(random) < 0.5;
      segment.length = std::pow(10.0, 1.5 * part(random) - 1.5);
      segment.v = poor ? 5.0 + 45.0 * part(random) : 200.0;
      segment.ramp.a = poor ? 20.0 + 300.0 * part(random) : 2500.0;
      segment.ramp.j = poor ? 500.0 + 5e3 * part(random) : 5e4;
    }
    SCOPED_TRACE(seed);
    expect_limits(segments, plan(segments));
  }
}

TEST(SpeedPlan, StartTooFastToStopIsToldSo) {
  SpeedPlan planner;
  EXPECT_FALSE(planner.plan({{.length = 1.0, .v = 200.0, .ramp = machine}}, 200.0));
}

}  // namespace
}  // namespace stanok::motion
