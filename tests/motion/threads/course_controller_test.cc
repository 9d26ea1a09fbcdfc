// The controller of a chain that a spindle leads, by itself: on courses that are formulas.
#include "motion/threads/course_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using kinematics::Jet;
using stanok::testing::cycle_s;

constexpr RampLimits course_limits{.a = 400.0, .j = 20000.0};     // turns/s^2, turns/s^3
constexpr CourseController::SpeedRange speed_range{.max = 30.0};  // turns/s
constexpr double limit_rounding = 1e-12;
// A bound of the speed in steps of cycles is passed by so much.
constexpr double between_cycles = course_limits.j * cycle_s * cycle_s / 8.0;

TEST(CourseController, ComesOntoASteadyCourseAndStaysThere) {
  const CourseController controller(cycle_s);
  PathMotion motion{.s = -0.004, .v = 10.0};
  for (int n = 1; n <= 500; ++n) {
    const Jet course{10.0 * n * cycle_s, 10.0, 0.0, 0.0};
    motion = controller.advance(motion, course, course_limits, speed_range);
  }
  EXPECT_NEAR(motion.s, 5.0, 1e-9);
  EXPECT_NEAR(motion.v, 10.0, 1e-7);
  EXPECT_TRUE(controller.is_settled(motion, {5.0 + 10.0 * cycle_s, 10.0, 0.0, 0.0}, course_limits));
}

// From rest onto a course that runs already, half a turn ahead: as fast as the limits allow.
TEST(CourseController, KeepsItsLimitsWhereTheCourseIsFarOff) {
  const CourseController controller(cycle_s);
  PathMotion motion;
  EXPECT_FALSE(controller.is_settled(motion, {0.5, 10.0, 0.0, 0.0}, course_limits));
  for (int n = 1; n <= 2000; ++n) {
    const Jet course{0.5 + 10.0 * n * cycle_s, 10.0, 0.0, 0.0};
    motion = controller.advance(motion, course, course_limits, speed_range);
    ASSERT_LE(std::abs(motion.j), course_limits.j * (1.0 + limit_rounding)) << n;
    ASSERT_LE(std::abs(motion.a), course_limits.a * (1.0 + limit_rounding)) << n;
    ASSERT_LE(motion.v, speed_range.max + between_cycles) << n;
  }
  EXPECT_NEAR(motion.s, 20.5, 1e-9);
}

TEST(CourseController, DoesNotGoBackWhereThatIsNotAllowed) {
  const CourseController controller(cycle_s);
  PathMotion motion{.s = 1.0, .v = 10.0};
  double slowest = motion.v;
  for (int n = 1; n <= 500; ++n) {
    const Jet course{1.0 - 10.0 * n * cycle_s, -10.0, 0.0, 0.0};
    motion = controller.advance(motion, course, course_limits, speed_range);
    slowest = std::min(slowest, motion.v);
  }
  EXPECT_GE(slowest, -between_cycles);
  EXPECT_NEAR(motion.v, 0.0, between_cycles);
}

// A finer encoder has smaller steps: the jerk is inverse to the pulses.
TEST(CourseController, AFinerEncoderNeedsLessJerk) {
  EXPECT_DOUBLE_EQ(jerk_to_follow(1024, cycle_s), 4.0 * jerk_to_follow(4096, cycle_s));
}

}  // namespace
}  // namespace stanok::motion
