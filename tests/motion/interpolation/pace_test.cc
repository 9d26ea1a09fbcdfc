// The pace of a plan: within the limits that its inequalities state, never backwards, and a lower
// override is never ahead of a higher one.
#include "motion/interpolation/pace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

constexpr double pace_cycle = 0.001;

// Of plans whose limits are met in 5 ms to 2 s.
PaceLimits random_limits(Random& random) {
  const double velocity = std::pow(10.0, random.between(-2.3, 0.3));
  const double coupling = std::pow(10.0, random.between(-2.5, -0.5));
  return {.use = static_cast<float>(random.between(0.5, 0.997)),
          .velocity = static_cast<float>(velocity),
          .thrust = static_cast<float>(velocity * coupling * random.between(0.2, 5.0)),
          .coupling = static_cast<float>(coupling)};
}

// What the largest use of acceleration and jerk may be within a step.
double largest_use(const PaceStep& step, const PaceLimits& limits) {
  double use = 0.0;
  for (int k = 0; k <= 4; ++k) {
    const Pace at = step.after(0.25 * k * pace_cycle);
    const double p = at.rate;
    const double d = std::abs(at.change);
    use = std::max(use, limits.use * p * p + d * limits.velocity);
    use = std::max(use, limits.use * p * p * p + 3.0 * p * d * limits.coupling +
                            std::abs(step.second) * limits.thrust);
  }
  return use;
}

// Never backwards nor faster than the plan within a step, and at its end where it ends.
void expect_within(const PaceStep& step) {
  for (int k = 0; k <= 8; ++k) {
    const double rate = step.after(0.125 * k * pace_cycle).rate;
    ASSERT_GE(rate, 0.0);
    ASSERT_LE(rate, 1.0);
  }
  ASSERT_NEAR(step.after(pace_cycle).rate, step.to.rate, 1e-5);
  ASSERT_NEAR(step.after(pace_cycle).change, step.to.change, 1e-9);
}

TEST(Pace, KeepsTheLimitsUnderAnyTargets) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PaceLimits limits = random_limits(random);
    Pace pace;
    double target = 1.0;
    for (int k = 0; k < 4000; ++k) {
      if (random.chance(0.004)) target = random.chance(0.3) ? 0.0 : random.between(0.0, 1.0);
      if (random.chance(0.001)) target = 1.0;
      const PaceStep step = step_pace(pace, target, limits, limits, pace_cycle);
      ASSERT_LE(largest_use(step, limits), 1.0 + 1e-9) << "cycle " << k;
      ASSERT_GE(step.advance, 0.0);
      expect_within(step);
      pace = step.to;
    }
  }
}

// What comes leaves less, or nothing at the full pace: there the change is within what that leaves
// soon, and until then the limits here hold.
TEST(Pace, IsReadyForWhatComes) {
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PaceLimits limits = random_limits(random);
    const bool is_other = random.chance(0.5);
    PaceLimits next = is_other ? random_limits(random) : limits;
    if (random.chance(0.5)) next.use = 1.0F;
    const PaceLimits ahead = highest_of(limits, next);
    Pace pace{.rate = random.between(0.0, 1.0)};
    const auto rising = static_cast<int>(random.between(0.0, 1000.0));
    for (int k = 0; k < rising; ++k) pace = step_pace(pace, 1.0, limits, limits, pace_cycle).to;
    const double soon = 2.0 * settling_time(limits);
    for (int k = 0; k * pace_cycle < soon; ++k) {
      const PaceStep step = step_pace(pace, 1.0, limits, ahead, pace_cycle);
      ASSERT_LE(largest_use(step, limits), 1.0 + 1e-9) << "cycle " << k;
      pace = step.to;
    }
    for (int k = 0; k < 1000; ++k) {
      const PaceStep step = step_pace(pace, pace.rate, next, next, pace_cycle);
      ASSERT_LE(largest_use(step, next), 1.0 + 1e-9) << "cycle " << k;
      pace = step.to;
    }
  }
}

TEST(Pace, ComesToItsTargetAndStaysThere) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PaceLimits limits = random_limits(random);
    Pace pace{.rate = random.between(0.0, 1.0)};
    for (const double target : {0.0, random.between(0.0, 1.0), 1.0}) {
      for (int k = 0; k < 200000 && (pace.rate != target || pace.change != 0.0); ++k) {
        pace = step_pace(pace, target, limits, limits, pace_cycle).to;
      }
      EXPECT_EQ(pace.rate, target);
      EXPECT_EQ(pace.change, 0.0);
    }
    EXPECT_TRUE(pace.is_nominal());
  }
}

TEST(Pace, ALowerTargetIsSoonBehind) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PaceLimits limits = random_limits(random);
    const double begun = random.between(0.0, 1.0);
    const double low = random.between(0.0, 1.0);
    const double high = random.between(low, 1.0);
    Pace slow{.rate = begun};
    Pace fast{.rate = begun};
    double behind = 0.0;
    for (int k = 0; k < 3000; ++k) {
      const PaceStep one = step_pace(slow, low, limits, limits, pace_cycle);
      const PaceStep other = step_pace(fast, high, limits, limits, pace_cycle);
      behind += other.advance - one.advance;
      ASSERT_GE(behind, -0.02);  // s: it may be reached a little sooner
      slow = one.to;
      fast = other.to;
    }
    if (high > low + 0.02) {
      EXPECT_GT(behind, 0.0);
    }
  }
}

TEST(Pace, GoesOnFromWhatItSaysItGoesOnFrom) {
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    const PaceLimits limits = random_limits(random);
    Pace pace{.rate = random.between(0.0, 1.0), .change = random.between(-20.0, 20.0)};
    if (!goes_on_from(pace, limits, pace_cycle)) continue;
    ++taken;
    const double target = random.chance(0.5) ? 1.0 : random.between(0.0, 1.0);
    for (int k = 0; k < 2000; ++k) {
      const PaceStep step = step_pace(pace, target, limits, limits, pace_cycle);
      ASSERT_LE(largest_use(step, limits), 1.0 + 1e-9) << "seed " << seed << " cycle " << k;
      ASSERT_GE(step.to.rate + 1e-12, 0.0);
      pace = step.to;
    }
  }
  EXPECT_GT(taken, 200);
}

TEST(Pace, TimeOfAPartOfAStep) {
  const PaceLimits limits{.use = 0.9F, .velocity = 0.1F, .thrust = 0.01F, .coupling = 0.1F};
  const PaceStep step = step_pace({.rate = 0.7, .change = 0.1}, 0.2, limits, limits, pace_cycle);
  EXPECT_NEAR(step.time_of(step.advance, pace_cycle), pace_cycle, 1e-15);
  const double half = step.time_of(0.5 * step.advance, pace_cycle);
  // The plan's time by Simpson's rule, exact for the square of t.
  const double area =
      half / 6.0 * (step.from.rate + 4.0 * step.after(0.5 * half).rate + step.after(half).rate);
  EXPECT_NEAR(area, 0.5 * step.advance, 1e-16);
}

// d/dt of s(tau(t)) by the chain rule, against differences of s itself.
TEST(Pace, MovesThePathByTheChainRule) {
  const Phase phase{.duration = 1.0, .s = 2.0, .v = 3.0, .a = -1.5, .j = 4.0};
  const Pace pace{.rate = 0.6, .change = 0.8};
  const double second = -2.0;
  const auto s_at = [&](double t) {
    const double tau = 0.4 + t * (pace.rate + t * (0.5 * pace.change + t * second / 6.0));
    return motion_at(phase, tau).s;
  };
  const PathMotion motion = at_pace(motion_at(phase, 0.4), pace, second);
  constexpr double h = 1e-3;
  EXPECT_NEAR(motion.s, s_at(0.0), 1e-15);
  EXPECT_NEAR(motion.v, (s_at(h) - s_at(-h)) / (2.0 * h), 1e-5);
  EXPECT_NEAR(motion.a, (s_at(h) - 2.0 * s_at(0.0) + s_at(-h)) / (h * h), 1e-4);
  EXPECT_NEAR(motion.j,
              (s_at(2 * h) - 2.0 * s_at(h) + 2.0 * s_at(-h) - s_at(-2 * h)) / (2.0 * h * h * h),
              1e-3);
}

}  // namespace
}  // namespace stanok::motion
