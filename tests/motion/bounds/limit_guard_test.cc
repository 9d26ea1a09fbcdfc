// The last guard of soft limits against motions integrated step by step.
#include "motion/bounds/limit_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "motion/profile/axis_move.h"

namespace stanok::motion {
namespace {

// The earliest stop, by small steps: full jerk against the motion up to the limit of acceleration.
double stepped(double v, double a, double acceleration_max, double jerk_max) {
  constexpr double dt = 1e-6;
  double x = 0.0;
  double farthest = 0.0;
  for (int k = 0; k < 4'000'000; ++k) {
    const double a_next = std::max(-acceleration_max, a - jerk_max * dt);
    const double v_next = v + 0.5 * (a + a_next) * dt;
    x += 0.5 * (v + v_next) * dt;
    a = a_next;
    v = v_next;
    farthest = std::max(farthest, x);
    if (v < 0.0 && a < 0.0) break;
  }
  return farthest;
}

TEST(LimitGuard, StoppingDistanceIsThatOfAStopInSmallSteps) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int trial = 0; trial < 60; ++trial) {
    const double acceleration_max = 500.0 + 2000.0 * std::abs(part(random));
    const double jerk_max = 1e4 + 5e4 * std::abs(part(random));
    const double v = 250.0 * part(random);
    const double a = acceleration_max * part(random);
    const double expected = stepped(v, a, acceleration_max, jerk_max);
    EXPECT_NEAR(stopping_distance(v, a, acceleration_max, jerk_max), expected,
                1e-5 * (1.0 + expected))
        << v << " " << a;
  }
}

TEST(LimitGuard, WithoutALimitOfJerkItIsTheParabolaOfTheSchoolbook) {
  EXPECT_DOUBLE_EQ(stopping_distance(100.0, 300.0, 1000.0, unlimited), 5.0);
  EXPECT_DOUBLE_EQ(stopping_distance(-100.0, 300.0, 1000.0, unlimited), 0.0);
}

// A move right up to the limit keeps a way to stand all along, and is not disturbed; the same move
// with the limit nearer by more than the slack is caught before it passes it by more than the
// slack.
TEST(LimitGuard, IsSilentOnMovesThatEndAtTheLimitAndCatchesThoseBeyond) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    AxisLimits limits;
    limits.velocity_max = 20.0 + 300.0 * part(random);
    limits.acceleration_max = 300.0 + 3000.0 * part(random);
    limits.jerk_max = 5e3 + 1e5 * part(random);
    limits.position_max = 100.0 * part(random);
    const double start = -200.0 * part(random);
    const double sign = part(random) < 0.5 ? 1.0 : -1.0;
    AxisMove move;
    move.begin(sign * start, sign * limits.position_max,
               {limits.velocity_max, {limits.acceleration_max, limits.jerk_max}});
    if (sign < 0.0) {
      limits.position_min = -limits.position_max;
      limits.position_max = unlimited;
    }
    AxisLimits nearer = limits;
    const double moved = 0.5 + 5.0 * part(random);
    (sign > 0.0 ? nearer.position_max : nearer.position_min) -= sign * moved;
    bool is_caught = false;
    for (int k = 0; k < 20'000 && !move.is_at_rest(); ++k) {
      move.advance(1e-3);
      const kinematics::Jet axis = move.position();
      EXPECT_FALSE(passes_limit(axis, limits, 1e-6)) << trial << " " << k;
      if (!is_caught && passes_limit(axis, nearer, 1e-6)) {
        is_caught = true;
        const double rest = stopping_distance(sign * axis.first, sign * axis.second,
                                              limits.acceleration_max, limits.jerk_max);
        const double end = sign * axis.value + rest;
        const double limit = sign > 0.0 ? nearer.position_max : -nearer.position_min;
        EXPECT_LE(end, limit + 5.0 * limits.velocity_max * 1e-3);
      }
    }
    EXPECT_TRUE(is_caught) << trial;
  }
}

}  // namespace
}  // namespace stanok::motion
