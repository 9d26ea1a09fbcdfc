// The law of a thread by itself: where the path is to be, by the angle of the spindle alone.
#include "motion/threads/thread_law.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

constexpr double speed_of_ramp = 10.0;  // turns/s
constexpr RampLimits thread_ramp{.a = 100.0, .j = 2000.0};

// A spindle in its direction that has turned so far since the ramp began.
SpindleMotion turned(double turns, double direction, double turns_per_s) {
  return {.turns = direction * turns, .speed = direction * turns_per_s};
}

// With the ramp to 10 turns/s, which is half as long as what the spindle turns meanwhile.
RunInStart from_rest(double direction) {
  const double half = 0.5 * speed_of_ramp * ramp_duration(0.0, speed_of_ramp, thread_ramp);
  return {.direction = direction,
          .origin = half,
          .ramp = ramp_up(0.0, 0.0, speed_of_ramp, thread_ramp),
          .ramp_speed = speed_of_ramp};
}

class ThreadLawOfDirection : public ::testing::TestWithParam<double> {};

TEST_P(ThreadLawOfDirection, LeadsFromRestIntoTheTurnsOfTheSpindle) {
  const double direction = GetParam();
  const double duration = ramp_duration(0.0, speed_of_ramp, thread_ramp);
  const double half = 0.5 * speed_of_ramp * duration;
  ThreadLaw law;
  law.begin(from_rest(direction));
  EXPECT_EQ(law.advance(turned(0.0, direction, speed_of_ramp)).value, 0.0);
  EXPECT_EQ(law.advance(turned(0.0, direction, speed_of_ramp)).first, 0.0);
  // In the middle of the ramp half the speed, by symmetry.
  const kinematics::Jet middle =
      law.advance(turned(0.5 * speed_of_ramp * duration, direction, speed_of_ramp));
  EXPECT_NEAR(middle.first, 0.5 * speed_of_ramp, 1e-9);
  EXPECT_FALSE(law.is_in_law());
  const double later = speed_of_ramp * duration + 3.0;
  const kinematics::Jet behind = law.advance(turned(later, direction, speed_of_ramp));
  EXPECT_TRUE(law.is_in_law());
  EXPECT_NEAR(behind.value, half + 3.0, 1e-12);
  EXPECT_EQ(behind.first, speed_of_ramp);
}

INSTANTIATE_TEST_SUITE_P(ThreadLaw, ThreadLawOfDirection, ::testing::Values(1.0, -1.0));

// The ramp is played by the angle: a slower spindle leads the path through the same places.
TEST(ThreadLaw, ASlowerSpindleLeadsThroughTheSamePlaces) {
  ThreadLaw fast;
  ThreadLaw slow;
  fast.begin(from_rest(1.0));
  slow.begin(from_rest(1.0));
  for (double turns = 0.0; turns < 4.0; turns += 0.05) {
    const kinematics::Jet one = fast.advance(turned(turns, 1.0, speed_of_ramp));
    const kinematics::Jet other = slow.advance(turned(turns, 1.0, 0.5 * speed_of_ramp));
    EXPECT_EQ(one.value, other.value) << turns;
    EXPECT_NEAR(other.first, 0.5 * one.first, 1e-12) << turns;
  }
}

TEST(ThreadLaw, ARunInThatBeginsAnewIsNotInTheLaw) {
  ThreadLaw law;
  law.begin(from_rest(1.0));
  (void)law.advance(turned(20.0, 1.0, speed_of_ramp));
  EXPECT_TRUE(law.is_in_law());
  law.begin(from_rest(1.0));
  EXPECT_FALSE(law.is_in_law());
}

// A tap of 4 turns in its hole: whichever way the spindle turns out, a turn of it is one of the
// way.
TEST(ThreadLaw, BringsATapBackFromWhereItStands) {
  for (const double out : {-3.0, 3.0}) {
    ThreadLaw law;
    law.begin_at(4.0, 17.25, out);
    EXPECT_TRUE(law.is_in_law());
    const double way = out < 0.0 ? -1.0 : 1.0;
    const kinematics::Jet one = law.advance({.turns = 17.25 + way, .speed = out});
    EXPECT_NEAR(one.value, 3.0, 1e-12);
    EXPECT_NEAR(one.first, -3.0, 1e-12);
  }
}

}  // namespace
}  // namespace stanok::motion
