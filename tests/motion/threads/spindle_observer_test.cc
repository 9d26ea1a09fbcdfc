// What the observer makes of the angles of an encoder (docs/developer/motion.md#threads).
#include "motion/threads/spindle_observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using stanok::testing::cycle_s;

double within_turn(double turns) {
  return 360.0 * (turns - std::floor(turns));
}

TEST(SpindleObserver, KnowsACubicAndCountsItsTurns) {
  const auto turns = [](double t) { return 0.25 + 3.0 * t - 40.0 * t * t + 30.0 * t * t * t; };
  SpindleObserver observer;
  double t = 0.0;
  for (; t < 0.5; t += cycle_s) {
    observer.observe(within_turn(turns(t)));
    observer.advance(cycle_s, {});
  }
  const SpindleMotion now = observer.now();
  EXPECT_NEAR(now.turns, turns(t), 1e-9);  // backwards by then, more than a turn
  EXPECT_NEAR(now.speed, 3.0 - 80.0 * t + 90.0 * t * t, 1e-6);
  EXPECT_NEAR(now.acceleration, -80.0 + 180.0 * t, 1e-3);
  EXPECT_NEAR(now.jerk, 180.0, 0.1);
}

TEST(SpindleObserver, ErrsByTheFourthDerivativeOverTheBandwidth) {
  // theta = 10 t + A cos(w t): the fourth derivative is A w^4 cos(w t).
  const double w = 2.0 * std::numbers::pi * 2.0;
  const double amplitude = 0.2 * 10.0 / w;
  const auto turns = [&](double t) { return 10.0 * t + amplitude * std::cos(w * t); };
  SpindleObserver observer;
  double error = 0.0;
  for (int k = 0; k < 2000; ++k) {
    observer.observe(within_turn(turns(k * cycle_s)));
    if (k > 500) error = std::max(error, std::abs(observer.now().turns - turns(k * cycle_s)));
    observer.advance(cycle_s, {});
  }
  const double bound = amplitude * std::pow(w / SpindleObserver::bandwidth, 4);
  EXPECT_LE(error, bound);
  EXPECT_GE(error, 0.3 * bound);  // the poles lie where they are said to: a cycle makes it smaller
}

TEST(SpindleObserver, SettlesWithAnglesThatComeEveryTenCycles) {
  const auto turns = [](double t) { return 10.0 * t + 3.0 * t * t; };
  SpindleObserver observer;
  for (int k = 0; k <= 1000; ++k) {
    if (k % 10 == 0) observer.observe(within_turn(turns(k * cycle_s)));
    if (k < 1000) observer.advance(cycle_s, {});
  }
  EXPECT_NEAR(observer.now().turns, turns(1.0), 1e-9);
  EXPECT_NEAR(observer.now().speed, 16.0, 1e-6);
}

TEST(SpindleObserver, SmoothsTheCountsOfAnEncoder) {
  constexpr double counts = 4 * 1024;
  SpindleObserver observer;
  double error = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double turns = 7.3 * k * cycle_s;
    observer.observe(within_turn(std::round(turns * counts) / counts));
    if (k > 500) error = std::max(error, std::abs(observer.now().speed - 7.3));
    observer.advance(cycle_s, {});
  }
  // Differences of counts would be off by up to a count per cycle, 0.24 turns/s.
  EXPECT_LT(error, 0.25 / (counts * cycle_s));
}

TEST(SpindleObserver, KnowsACommandAtOnce) {
  // From 10 turns/s at -30 turns/s^2, with an index pulse a quarter of a turn aside.
  SpindleObserver observer;
  observer.observe(90.0);
  for (int k = 1; k <= 200; ++k) {
    const double t = k * cycle_s;
    const SpindleMotion commanded{
        .turns = 10.0 * t - 15.0 * t * t, .speed = 10.0 - 30.0 * t, .acceleration = -30.0};
    observer.advance(cycle_s, commanded);
    observer.observe(within_turn(0.25 + commanded.turns));
    EXPECT_NEAR(observer.now().turns, 0.25 + commanded.turns, 1e-12);
    EXPECT_NEAR(observer.now().speed, commanded.speed, 1e-9);
  }
}

}  // namespace
}  // namespace stanok::motion
