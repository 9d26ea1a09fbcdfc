#include "motion/interpolation/feed_interruption.h"

#include <algorithm>

namespace stanok::motion {
namespace {

constexpr double same_place_mm = 1e-9;
constexpr std::uint32_t pieces_per_look = 256;  // bound of work

}  // namespace

FeedInterruption::FeedInterruption(const MotionConfig& config) {
  for (const int axis : config.geometry) {
    if (axis >= 0) geometry_axes_ |= 1U << static_cast<unsigned>(axis);
  }
}

void FeedInterruption::set(const InterruptionLengths& lengths, const PathCursor& cursor, double s,
                           bool moves) RT_SAFE {
  lengths_ = lengths;
  count_ = 0;
  is_first_ = is_on() && moves;
  wall_ = {};
  is_found_ = false;
  left_mm_ = lengths.cut_mm;
  if (cursor.has_chunk()) seek(cursor, s, true);
}

void FeedInterruption::begin_chain(const PathCursor& cursor) RT_SAFE {
  next_piece_ = cursor.piece_number();
  next_s_ = 0.0;
}

void FeedInterruption::shift(double length) RT_SAFE {
  wall_.s -= length;
  next_s_ -= length;
}

void FeedInterruption::end_chain(double length) RT_SAFE {
  if (is_found_) left_mm_ = std::max(wall_.s - length, 0.0);
  is_found_ = false;
  wall_ = {};
}

bool FeedInterruption::is_counted(const Piece& piece) const RT_SAFE {
  return !piece.rapid && (piece.geometry.metric.axes & geometry_axes_) != 0;
}

void FeedInterruption::look(const PathQueue& queue, const PathCursor& cursor, double s) RT_SAFE {
  if (!is_on() || is_first_) return;
  // Run past: the path was not to be stopped there.
  if (is_found_ && s > wall_.s + same_place_mm) seek(cursor, s, is_counted(cursor.piece(queue)));
  if (is_found_) return;
  const std::uint64_t first = cursor.piece_number();
  const std::uint64_t behind_last = first + cursor.pieces_seen(queue);
  const std::uint64_t until = std::min(behind_last, next_piece_ + pieces_per_look);
  while (next_piece_ < until && !is_found_) {
    const Piece& piece = queue.pieces[static_cast<std::size_t>(next_piece_ - first)];
    if (is_counted(piece) && left_mm_ <= piece.length) {
      wall_ = {.piece = next_piece_, .s = next_s_ + left_mm_};
      feed_ = {.per_s = piece.feed_per_s, .rev_per_min = piece.process.rev_per_min};
      is_found_ = true;
      return;
    }
    if (is_counted(piece)) left_mm_ -= piece.length;
    next_s_ += piece.length;
    ++next_piece_;
  }
  wall_ = next_piece_ < behind_last ? PathWall{.piece = next_piece_ - 1, .s = next_s_} : PathWall{};
}

bool FeedInterruption::is_due(const Piece& piece, double s) const RT_SAFE {
  if (!is_on()) return false;
  if (is_first_) return is_counted(piece);
  return is_found_ && s >= wall_.s - same_place_mm;
}

StandFeed FeedInterruption::stand(const PathQueue& queue, const PathCursor& cursor, double s)
    RT_SAFE {
  const Piece& piece = cursor.piece(queue);
  if (is_first_) feed_ = {.per_s = piece.feed_per_s, .rev_per_min = piece.process.rev_per_min};
  is_first_ = false;
  ++count_;
  seek(cursor, s, is_counted(piece));
  return feed_;
}

// The next rest is L_B behind s, which lies in the piece at hand.
void FeedInterruption::seek(const PathCursor& cursor, double s, bool counts_from_s) RT_SAFE {
  is_found_ = false;
  wall_ = {};
  next_piece_ = cursor.piece_number();
  next_s_ = cursor.piece_start();
  left_mm_ = lengths_.cut_mm + (counts_from_s ? s - next_s_ : 0.0);
}

}  // namespace stanok::motion
