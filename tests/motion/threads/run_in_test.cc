// The run-in of a thread by itself: which spindles it waits for, and when it begins.
#include "motion/threads/run_in.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using stanok::testing::cycle_s;

constexpr SpindleCoupling::Section axes_section{.acceleration_max = 500.0, .jerk_max = 10000.0};

SpindleCoupling thread_at(double angle_deg) {
  SpindleCoupling coupling;
  coupling.kind = SpindleCoupling::Kind::thread;
  coupling.start_angle_deg = angle_deg;
  coupling.speed_max = 30.0;
  coupling.entry = coupling.chain = coupling.exit = axes_section;
  coupling.entry_end = coupling.exit_begin = 50.0;
  return coupling;
}

// A spindle that turns evenly, as long as the path waits or for three seconds.
struct Watched {
  RunIn::Answer answer = RunIn::Answer::waits;
  double turns = 0.0;  // at the end
};
Watched watch(RunIn& run_in, double speed, double speed_wanted) {
  Watched watched;
  for (int n = 0; n < 3000 && watched.answer == RunIn::Answer::waits; ++n) {
    watched.turns = 0.4 + n * cycle_s * speed;
    const SpindleMotion spindle{
        .turns = watched.turns, .speed = speed, .speed_wanted = speed_wanted};
    run_in.watch(spindle);
    watched.answer = run_in.advance(spindle);
  }
  return watched;
}

class RunInSpeed : public ::testing::TestWithParam<double> {};

TEST_P(RunInSpeed, BeginsHalfItsTurnsBeforeTheStartAngle) {
  const double speed = GetParam();
  RunIn run_in(cycle_s);
  run_in.begin(thread_at(90.0));
  const Watched watched = watch(run_in, speed, speed);
  ASSERT_EQ(watched.answer, RunIn::Answer::begins);
  const RunInStart& start = run_in.start();
  const double direction = speed < 0.0 ? -1.0 : 1.0;
  EXPECT_EQ(start.direction, direction);
  // s = 0 is at the start angle of the spindle, whichever way it turns.
  const double angle = direction * start.origin - 0.25;
  EXPECT_NEAR(angle, std::round(angle), 1e-12);
  // In the cycle in which it is due, not later.
  const double half = start.ramp[start.ramp.size() - 1].s_end;
  const double left = start.origin - direction * watched.turns;
  EXPECT_LE(left, half);
  EXPECT_GE(left, half - std::abs(speed) * cycle_s);
  EXPECT_EQ(start.ramp_speed, std::abs(speed));
}

INSTANTIATE_TEST_SUITE_P(RunIn, RunInSpeed, ::testing::Values(1.0, 10.0, 25.0, -10.0));

TEST(RunIn, WaitsForASpindleThatStandsOrHasNotComeToItsSpeed) {
  RunIn run_in(cycle_s);
  run_in.begin(thread_at(0.0));
  EXPECT_EQ(watch(run_in, 0.05, 0.05).answer, RunIn::Answer::waits);
  EXPECT_EQ(watch(run_in, 5.0, 10.0).answer, RunIn::Answer::waits);
}

TEST(RunIn, RefusesASpindleThatStaysTooFast) {
  RunIn run_in(cycle_s);
  run_in.begin(thread_at(0.0));
  EXPECT_EQ(watch(run_in, 45.0, 45.0).answer, RunIn::Answer::too_fast);
}

// Too fast now, but commanded to come down.
TEST(RunIn, WaitsForASpindleThatComesDown) {
  RunIn run_in(cycle_s);
  run_in.begin(thread_at(0.0));
  EXPECT_EQ(watch(run_in, 42.0, 29.5).answer, RunIn::Answer::waits);
}

TEST(RunIn, AnAngleThatPassesWhileThePathMayNotBeginDoesNotCount) {
  RunIn run_in(cycle_s);
  run_in.begin(thread_at(0.0));
  for (int n = 0; n < 1000; ++n) {
    const SpindleMotion spindle{.turns = n * cycle_s * 10.0, .speed = 10.0, .speed_wanted = 10.0};
    run_in.watch(spindle);
    run_in.forget_angle();
    ASSERT_EQ(run_in.advance(spindle), RunIn::Answer::waits) << n;
  }
}

// A corner so near that a run-in by the limits of the entry could not be braked off before it.
TEST(RunIn, BeforeANearCornerTheLimitsOfTheChainHold) {
  SpindleCoupling coupling = thread_at(0.0);
  coupling.chain = {.acceleration_max = 50.0, .jerk_max = 1000.0};
  RunIn run_in(cycle_s);
  run_in.begin(coupling);
  run_in.watch({.speed = 10.0, .speed_wanted = 10.0});
  EXPECT_EQ(run_in.limits().a, 500.0);
  coupling.entry_end = 0.1;
  run_in.begin(coupling);
  run_in.watch({.speed = 10.0, .speed_wanted = 10.0});
  EXPECT_EQ(run_in.limits().a, 50.0);
}

}  // namespace
}  // namespace stanok::motion
