// The next chain within the end of the current one, by itself.
#include "motion/interpolation/chain_overlap.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

// Along Y from (10, 0), while the current chain comes along X with 3 mm/s.
TEST(ChainOverlap, TheAxesMoveByTheSumOfBoth) {
  PathQueue queue(4);
  ASSERT_TRUE(queue.phases.push({.duration = 1.0, .v = 3.0, .s_end = 3.0}));
  ASSERT_TRUE(queue.phases.push({.duration = 1.0, .v = 4.0, .s_end = 4.0, .v_end = 4.0}));
  Segment along_y;
  along_y.length = 5.0;
  along_y.geometry.metric = {.axis_count = 2, .axes = 0b11};
  along_y.geometry.start = {10.0, 0.0};
  along_y.geometry.end = {10.0, 5.0};

  ChainOverlap overlap;
  EXPECT_TRUE(overlap.is_undecided());
  overlap.begin();
  EXPECT_TRUE(overlap.runs());
  EXPECT_EQ(overlap.advance(queue, 1, 0.25), 1.0);
  EXPECT_EQ(overlap.advance(queue, 1, 0.5), 1.0);
  JetPoint point{};
  point[0] = {9.0, 3.0, 0.0, 0.0};
  EXPECT_EQ(overlap.add(along_y, 2, point), 5.0);  // of 3 and 4 mm/s at right angles
  EXPECT_EQ(point[0].value, 9.0);
  EXPECT_EQ(point[1].value, 2.0);
  EXPECT_EQ(point[1].first, 4.0);

  const PathMotion motion = overlap.take_over();
  EXPECT_EQ(motion.s, 2.0);
  EXPECT_EQ(motion.v, 4.0);
  EXPECT_TRUE(overlap.is_undecided());
}

// What was dropped within an overlap leaves nothing to the next one.
TEST(ChainOverlap, ADroppedOneIsForgotten) {
  PathQueue queue(4);
  ASSERT_TRUE(queue.phases.push({.duration = 1.0, .v = 4.0, .s_end = 4.0, .v_end = 4.0}));
  ChainOverlap overlap;
  overlap.refuse();
  EXPECT_TRUE(overlap.is_refused());
  overlap.forget();
  overlap.begin();
  (void)overlap.advance(queue, 0, 0.5);
  overlap.forget();
  EXPECT_TRUE(overlap.is_undecided());
  overlap.begin();
  EXPECT_EQ(overlap.advance(queue, 0, 0.25), 1.0);
}

}  // namespace
}  // namespace stanok::motion
