// Committed phases in the chain's own clock, by themselves.
#include "motion/interpolation/nominal_run.h"

#include <gtest/gtest.h>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using stanok::testing::cycle_s;

// A chunk at 100 mm/s in two phases, of 2.5 and 7 cycles: 0.95 mm in 9.5 cycles.
class NominalRunTest : public ::testing::Test {
 protected:
  NominalRunTest() {
    Segment segment;
    segment.length = 0.95;
    EXPECT_TRUE(queue_.segments.push(segment));
    EXPECT_TRUE(
        queue_.phases.push({.duration = 0.0025, .v = 100.0, .s_end = 0.25, .v_end = 100.0}));
    EXPECT_TRUE(queue_.phases.push(
        {.duration = 0.007, .s = 0.25, .v = 100.0, .s_end = 0.95, .v_end = 100.0}));
    EXPECT_TRUE(queue_.chunks.push({.segments = 1, .phases = 2, .last = true, .length = 0.95}));
    cursor_.enter(queue_);
  }

  PathQueue queue_{4};
  PathCursor cursor_;
  NominalRun run_{cycle_s};
  PathMotion motion_;
};

TEST_F(NominalRunTest, LeavesOverWhatTheChunkDoesNotTakeOfACycle) {
  for (int n = 1; n <= 9; ++n) {
    EXPECT_EQ(run_.advance(queue_, cursor_, cycle_s, motion_), 0.0) << n;
    EXPECT_NEAR(motion_.s, 0.1 * n, 1e-12);
  }
  EXPECT_NEAR(run_.advance(queue_, cursor_, cycle_s, motion_), 0.5 * cycle_s, 1e-12);
  EXPECT_EQ(motion_.s, 0.95);
  EXPECT_FALSE(cursor_.has_phase());
}

TEST_F(NominalRunTest, APartOfACycleCountsToo) {
  EXPECT_EQ(run_.advance(queue_, cursor_, 0.3 * cycle_s, motion_), 0.0);
  EXPECT_EQ(run_.advance(queue_, cursor_, cycle_s, motion_), 0.0);
  EXPECT_NEAR(motion_.s, 0.13, 1e-12);
}

TEST_F(NominalRunTest, KnowsTheTimeToTheEnd) {
  run_.begin(0.001);
  EXPECT_NEAR(run_.time_to_end(queue_, cursor_, 1.0), 0.0085, 1e-12);
  EXPECT_GT(run_.time_to_end(queue_, cursor_, 0.001), 0.001);
}

TEST_F(NominalRunTest, RejoinsWhereTheMotionIsThatOfAPhase) {
  EXPECT_FALSE(run_.rejoin(queue_, cursor_, {.s = 0.3, .v = 90.0}));
  EXPECT_FALSE(run_.rejoin(queue_, cursor_, {.s = 0.3, .v = 100.0, .a = 1.0}));
  ASSERT_TRUE(run_.rejoin(queue_, cursor_, {.s = 0.3, .v = 100.0}));
  EXPECT_EQ(run_.advance(queue_, cursor_, cycle_s, motion_), 0.0);
  EXPECT_NEAR(motion_.s, 0.4, 1e-12);
}

}  // namespace
}  // namespace stanok::motion
