// Where the cycle stands in the queue of committed path.
#include "motion/interpolation/path_cursor.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

void push_chunk(PathQueue& queue, std::uint32_t pieces) {
  Piece piece;
  piece.length = 1.0;
  for (std::uint32_t k = 0; k < pieces; ++k) {
    ASSERT_TRUE(queue.pieces.push(piece));
    ASSERT_TRUE(queue.phases.push({.duration = 1.0, .v = 1.0, .s_end = 1.0, .v_end = 1.0}));
  }
  ASSERT_TRUE(queue.chunks.push(
      {.pieces = pieces, .phases = pieces, .length = static_cast<double>(pieces)}));
}

TEST(PathCursor, PiecesAreNumberedOverAllChunks) {
  PathQueue queue(16);
  push_chunk(queue, 3);
  push_chunk(queue, 2);
  PathCursor cursor;
  cursor.enter(queue);
  EXPECT_EQ(cursor.pieces_seen(queue), 5U);
  cursor.go_to(queue, 1.5);
  EXPECT_EQ(cursor.piece_number(), 1U);
  EXPECT_EQ(cursor.piece_start(), 1.0);
  cursor.leave(queue);
  cursor.enter(queue);
  EXPECT_EQ(cursor.piece_number(), 3U);
}

// What was seen ahead is kept by number (PathSight): no piece may take the number of another.
TEST(PathCursor, PiecesThatAreDroppedUnseenKeepTheirNumbers) {
  PathQueue queue(16);
  push_chunk(queue, 3);
  push_chunk(queue, 2);
  PathCursor cursor;
  cursor.enter(queue);
  cursor.go_to(queue, 1.5);
  cursor.drop(queue);
  EXPECT_FALSE(cursor.has_chunk());
  EXPECT_EQ(queue.chunks.size() + queue.pieces.size() + queue.phases.size(), 0U);
  push_chunk(queue, 4);
  cursor.enter(queue);
  EXPECT_EQ(cursor.piece_number(), 5U);
  EXPECT_EQ(cursor.pieces_left(), 4U);
}

}  // namespace
}  // namespace stanok::motion
