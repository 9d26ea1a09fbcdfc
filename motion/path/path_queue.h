// The queue of committed path between preparation (producer) and cycle (consumer).
#pragma once

#include "base/ring.h"
#include "motion/path/path.h"

namespace stanok::motion {

struct PathQueue {
  explicit PathQueue(std::size_t piece_capacity = 16384)
      : pieces(piece_capacity), phases(piece_capacity * 4), chunks(256) {}
  Ring<Piece> pieces;
  Ring<Phase> phases;
  Ring<Chunk> chunks;  // pushed last: a chunk in the ring has all its pieces and phases in theirs

  // Consumer. It sees the first `count` chunks pushed since construction, and of pieces and phases
  // what belongs to them.
  void show(std::size_t count) RT_SAFE {
    std::size_t place = chunks.shown() - chunks.popped();
    chunks.show(count);
    for (; place < chunks.size(); ++place) {
      shown_pieces_ += chunks[place].pieces;
      shown_phases_ += chunks[place].phases;
    }
    pieces.show(shown_pieces_);
    phases.show(shown_phases_);
  }

 private:
  std::size_t shown_pieces_ = 0;  // since construction
  std::size_t shown_phases_ = 0;
};

}  // namespace stanok::motion
