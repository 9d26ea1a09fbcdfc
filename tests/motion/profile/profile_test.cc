// Closed-form S-curves against numerical integration and their own limits.
#include "motion/profile/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stanok::motion {
namespace {

constexpr RampLimits ramp_limits{.a = 2000.0, .j = 50000.0};

// End of a run of phases by their closed forms, checking that they join.
template <class Run>
PathMotion run_through(const Run& run, PathMotion from, const RampLimits& bounds) {
  for (const Phase& phase : run) {
    EXPECT_NEAR(phase.s, from.s, 1e-11 * (1.0 + std::abs(from.s)));
    EXPECT_NEAR(phase.v, from.v, 1e-10 * (1.0 + from.v));
    EXPECT_NEAR(phase.a, from.a, 1e-9 * (1.0 + std::abs(from.a)));
    EXPECT_LE(std::abs(phase.j), bounds.j);
    EXPECT_GE(phase.duration, 0.0);
    from = motion_at(phase, phase.duration);
    EXPECT_NEAR(from.s, phase.s_end, 1e-11 * (1.0 + std::abs(from.s)));
    EXPECT_NEAR(from.v, phase.v_end, 1e-10 * (1.0 + from.v));
  }
  return from;
}

TEST(Profile, ShortSpeedChangeHasNoConstantAccelerationPart) {
  // dv = 20 < A^2 / J = 80: T = 2 sqrt(20 / 50000) = 0.04 s, D = (10 + 30) / 2 * 0.04.
  EXPECT_DOUBLE_EQ(ramp_duration(10.0, 30.0, ramp_limits), 0.04);
  EXPECT_DOUBLE_EQ(ramp_distance(10.0, 30.0, ramp_limits), 0.8);
  EXPECT_EQ(ramp_up(0.0, 10.0, 30.0, ramp_limits).size(), 2U);
}

TEST(Profile, LongSpeedChangeRunsAtTheAccelerationLimit) {
  // dv = 200 > 80: T = 2000 / 50000 + 200 / 2000 = 0.14 s.
  EXPECT_DOUBLE_EQ(ramp_duration(200.0, 0.0, ramp_limits), 0.14);
  EXPECT_DOUBLE_EQ(ramp_distance(200.0, 0.0, ramp_limits), 14.0);
  EXPECT_EQ(ramp_down(200.0, 14.0, 0.0, ramp_limits).size(), 3U);
}

TEST(Profile, RampsEndExactlyWhereTheyShould) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> speed(0.0, 500.0);
  for (int k = 0; k < 2000; ++k) {
    const double low = speed(random);
    const double high = low + speed(random);
    const RampLimits bounds{.a = 100.0 + 10.0 * speed(random), .j = 1e4 + 500.0 * speed(random)};
    const double distance = ramp_distance(low, high, bounds);
    const PathMotion up =
        run_through(ramp_up(3.0, low, high, bounds), {.s = 3.0, .v = low}, bounds);
    EXPECT_NEAR(up.s, 3.0 + distance, 1e-11 * (1.0 + distance));
    EXPECT_NEAR(up.v, high, 1e-10 * (1.0 + high));
    const PhaseRun down = ramp_down(high, 7.0, low, bounds);
    EXPECT_EQ(down[down.size() - 1].s_end, 7.0);
    EXPECT_EQ(down[down.size() - 1].v_end, low);
    EXPECT_EQ(down[0].v, high);
    run_through(down, {.s = 7.0 - distance, .v = high}, bounds);
  }
}

TEST(Profile, DistanceToASpeedWithinTheRampAgreesWithThePhases) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const double low = 100.0 * part(random);
    const double high = low + 300.0 * part(random) + 1e-3;
    const PhaseRun up = ramp_up(0.0, low, high, ramp_limits);
    const RampCourse course(low, high, ramp_limits);
    EXPECT_EQ(course.length(), ramp_distance(low, high, ramp_limits));
    for (const Phase& phase : up) {
      const PathMotion inside = motion_at(phase, part(random) * phase.duration);
      EXPECT_NEAR(course.distance_to(inside.v), inside.s, 1e-9);
    }
  }
}

TEST(Profile, TimeAtAPlaceIsWhenThePhaseComesThere) {
  std::mt19937_64 random(16);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const double low = 100.0 * part(random) * static_cast<double>(k % 3 != 0);
    const double high = low + 300.0 * part(random) + 1e-3;
    for (const Phase& phase : ramp_up(7.0, low, high, ramp_limits)) {
      const double t = part(random) * phase.duration;
      const PathMotion inside = motion_at(phase, t);
      if (!(phase.s < inside.s && inside.s < phase.s_end)) continue;
      // A place is known to its rounding, which is more time where the motion is slow.
      EXPECT_NEAR(time_at(phase, inside.s), t, 1e-14 + 4e-15 / inside.v);
    }
  }
}

TEST(Profile, ReachableSpeedUsesTheWholeDistance) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 2000; ++k) {
    const double v0 = 200.0 * part(random) * static_cast<double>(k % 3 != 0);
    const double distance = std::pow(10.0, 6.0 * part(random) - 4.0);
    const double v = reachable_speed(v0, distance, ramp_limits);
    EXPECT_LE(ramp_distance(v0, v, ramp_limits), distance);
    EXPECT_GE(ramp_distance(v0, v + 1e-12 * (1.0 + v), ramp_limits), distance);
  }
}

TEST(Profile, PeakSpeedFillsTheDistanceWithTwoRamps) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 2000; ++k) {
    const double v0 = 100.0 * part(random);
    const double v1 = 100.0 * part(random);
    const RampLimits down{.a = 300.0 + 3000.0 * part(random), .j = 1e4 + 1e5 * part(random)};
    const double least = ramp_distance(v0, v1, v0 < v1 ? ramp_limits : down);
    const double distance = least + std::pow(10.0, 5.0 * part(random) - 3.0);
    const double top = peak_speed(v0, v1, distance, ramp_limits, down, 1e5);
    const double used = ramp_distance(v0, top, ramp_limits) + ramp_distance(top, v1, down);
    EXPECT_LE(used, distance);
    const double above = top + 1e-12 * (1.0 + top);
    EXPECT_GE(ramp_distance(v0, above, ramp_limits) + ramp_distance(above, v1, down), distance);
  }
}

TEST(Profile, ChangeOfSpeedFromAnyStateEndsAtTheTargetWithoutAcceleration) {
  std::mt19937_64 random(15);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 5000; ++k) {
    const double a = (2.0 * part(random) - 1.0) * 2500.0;  // beyond the limit now and then
    const double v = 80.0 + 300.0 * part(random);
    const double target = 400.0 * part(random);
    const PhaseRun run = change_speed({.s = 1.0, .v = v, .a = a}, target, ramp_limits);
    const PathMotion end = run_through(run, {.s = 1.0, .v = v, .a = a}, ramp_limits);
    EXPECT_NEAR(end.v, target, 1e-9 * (1.0 + target));
    EXPECT_NEAR(end.a, 0.0, 1e-8);
    if (run.size() > 0) {
      EXPECT_EQ(run[run.size() - 1].v_end, target);
    }
  }
}

TEST(Profile, AccelerationTakenAwayAtOnceLeavesTheEasedSpeed) {
  EXPECT_DOUBLE_EQ(eased_speed(100.0, 1000.0, 50000.0), 110.0);
  EXPECT_DOUBLE_EQ(eased_speed(100.0, -1000.0, 50000.0), 90.0);
}

}  // namespace
}  // namespace stanok::motion
