#include "motion/interpolation/path_cursor.h"

#include <algorithm>

namespace stanok::motion {

void PathCursor::enter(PathQueue& queue) RT_SAFE {
  has_chunk_ = queue.chunks.pop(chunk_);
  pieces_left_ = chunk_.pieces;
  phases_left_ = chunk_.phases;
  piece_start_ = 0.0;
}

void PathCursor::leave(PathQueue& queue) RT_SAFE {
  queue.pieces.pop_front(pieces_left_);
  queue.phases.pop_front(phases_left_);
  piece_number_ += pieces_left_;
  pieces_left_ = 0;
  phases_left_ = 0;
  has_chunk_ = false;
}

void PathCursor::drop(PathQueue& queue) RT_SAFE {
  piece_number_ += queue.pieces.size();
  queue.chunks.pop_front(queue.chunks.size());
  queue.pieces.pop_front(queue.pieces.size());
  queue.phases.pop_front(queue.phases.size());
  pieces_left_ = 0;
  phases_left_ = 0;
  has_chunk_ = false;
}

void PathCursor::go_to(PathQueue& queue, double s, std::uint64_t closed_from_block) RT_SAFE {
  while (pieces_left_ > 1 && s >= piece_start_ + queue.pieces.front().length &&
         queue.pieces[1].tag.block < closed_from_block) {
    piece_start_ += queue.pieces.front().length;
    queue.pieces.pop_front();
    --pieces_left_;
    ++piece_number_;
  }
}

double PathCursor::s_in_piece(const PathQueue& queue, double s) const RT_SAFE {
  const double length = queue.pieces.front().length;
  if (pieces_left_ == 1 && s >= chunk_.length) return length;
  return std::clamp(s - piece_start_, 0.0, length);
}

void PathCursor::pass_phase(PathQueue& queue) RT_SAFE {
  queue.phases.pop_front();
  --phases_left_;
}

std::uint32_t PathCursor::pieces_seen(const PathQueue& queue) const RT_SAFE {
  if (chunk_.last || queue.chunks.empty()) return pieces_left_;
  return pieces_left_ + queue.chunks.front().pieces;
}

}  // namespace stanok::motion
