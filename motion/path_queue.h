// The queue of committed path between preparation (producer) and cycle (consumer).
#pragma once

#include "base/ring.h"
#include "motion/path.h"

namespace stanok::motion {

struct PathQueue {
  explicit PathQueue(std::size_t piece_capacity = 16384)
      : pieces(piece_capacity), phases(piece_capacity * 4), chunks(256) {}
  Ring<Piece> pieces;
  Ring<Phase> phases;
  Ring<Chunk> chunks;  // pushed last: a chunk in the ring has all its pieces and phases in theirs
};

}  // namespace stanok::motion
