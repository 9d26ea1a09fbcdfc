// Where the cycle stands in the queue of committed path.
#include "motion/interpolation/path_cursor.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

void push_chunk(PathQueue& queue, std::uint32_t segments) {
  Segment segment;
  segment.length = 1.0;
  for (std::uint32_t k = 0; k < segments; ++k) {
    ASSERT_TRUE(queue.segments.push(segment));
    ASSERT_TRUE(queue.phases.push({.duration = 1.0, .v = 1.0, .s_end = 1.0, .v_end = 1.0}));
  }
  ASSERT_TRUE(queue.chunks.push(
      {.segments = segments, .phases = segments, .length = static_cast<double>(segments)}));
}

TEST(PathCursor, SegmentsAreNumberedOverAllChunks) {
  PathQueue queue(16);
  push_chunk(queue, 3);
  push_chunk(queue, 2);
  PathCursor cursor;
  cursor.enter(queue);
  EXPECT_EQ(cursor.segments_seen(queue), 5U);
  cursor.go_to(queue, 1.5);
  EXPECT_EQ(cursor.segment_number(), 1U);
  EXPECT_EQ(cursor.segment_start(), 1.0);
  cursor.leave(queue);
  cursor.enter(queue);
  EXPECT_EQ(cursor.segment_number(), 3U);
}

// What was seen ahead is kept by number (PathSight): no segment may take the number of another.
TEST(PathCursor, SegmentsThatAreDroppedUnseenKeepTheirNumbers) {
  PathQueue queue(16);
  push_chunk(queue, 3);
  push_chunk(queue, 2);
  PathCursor cursor;
  cursor.enter(queue);
  cursor.go_to(queue, 1.5);
  cursor.drop(queue);
  EXPECT_FALSE(cursor.has_chunk());
  EXPECT_EQ(queue.chunks.size() + queue.segments.size() + queue.phases.size(), 0U);
  push_chunk(queue, 4);
  cursor.enter(queue);
  EXPECT_EQ(cursor.segment_number(), 5U);
  EXPECT_EQ(cursor.segments_left(), 4U);
}

}  // namespace
}  // namespace stanok::motion
