#include "motion/interpolation/feed_interruption.h"

#include <algorithm>

namespace stanok::motion {
namespace {

constexpr double same_place_mm = 1e-9;
constexpr std::uint32_t segments_per_look = 256;  // bound of work

}  // namespace

FeedInterruption::FeedInterruption(const MotionConfig& config) {
  for (const int axis : config.geometry) {
    if (axis >= 0) geometry_axes_ |= 1U << static_cast<unsigned>(axis);
  }
}

void FeedInterruption::set(const InterruptionLengths& lengths, const PathCursor& cursor,
                           const PathMotion& motion) RT_SAFE {
  lengths_ = lengths;
  count_ = 0;
  is_first_ = is_on() && !is_at_rest(motion);
  wall_ = {};
  is_found_ = false;
  left_mm_ = lengths.cut_mm;
  if (cursor.has_chunk()) seek(cursor, motion.s - cursor.segment_start());
}

void FeedInterruption::begin_chain(const PathCursor& cursor) RT_SAFE {
  next_segment_ = cursor.segment_number();
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

bool FeedInterruption::is_counted(const Segment& segment) const RT_SAFE {
  return !segment.rapid && (segment.geometry.metric.axes & geometry_axes_) != 0;
}

void FeedInterruption::look(const PathQueue& queue, const PathCursor& cursor, double s) RT_SAFE {
  if (!is_on() || is_first_) return;
  // Run past: the path was not to be stopped there.
  if (is_found_ && s > wall_.s + same_place_mm) seek(cursor, counted_until(queue, cursor, s));
  if (is_found_) return;
  const std::uint64_t first = cursor.segment_number();
  const std::uint64_t behind_last = first + cursor.segments_seen(queue);
  const std::uint64_t until = std::min(behind_last, next_segment_ + segments_per_look);
  while (next_segment_ < until && !is_found_) {
    const Segment& segment = queue.segments[next_segment_ - first];
    if (is_counted(segment) && left_mm_ <= segment.length) {
      wall_ = {.segment = next_segment_, .s = next_s_ + left_mm_};
      feed_ = {.per_s = segment.feed_per_s, .rev_per_min = segment.process.rev_per_min};
      is_found_ = true;
      return;
    }
    if (is_counted(segment)) left_mm_ -= segment.length;
    next_s_ += segment.length;
    ++next_segment_;
  }
  wall_ = next_segment_ < behind_last ? PathWall{.segment = next_segment_ - 1, .s = next_s_}
                                      : PathWall{};
}

bool FeedInterruption::is_due(const Segment& segment, double s) const RT_SAFE {
  if (!is_on()) return false;
  if (is_first_) return is_counted(segment);
  return is_found_ && s >= wall_.s - same_place_mm;
}

StandFeed FeedInterruption::stand(const PathQueue& queue, const PathCursor& cursor, double s)
    RT_SAFE {
  const Segment& segment = cursor.segment(queue);
  if (is_first_) feed_ = {.per_s = segment.feed_per_s, .rev_per_min = segment.process.rev_per_min};
  is_first_ = false;
  ++count_;
  seek(cursor, counted_until(queue, cursor, s));
  return feed_;
}

// What of the current segment counts up to s, which lies in it.
double FeedInterruption::counted_until(const PathQueue& queue, const PathCursor& cursor,
                                       double s) const RT_SAFE {
  return is_counted(cursor.segment(queue)) ? s - cursor.segment_start() : 0.0;
}

// The next rest is L_B behind a place in the current segment, of which so much counts up to there.
void FeedInterruption::seek(const PathCursor& cursor, double counted_mm) RT_SAFE {
  is_found_ = false;
  wall_ = {};
  next_segment_ = cursor.segment_number();
  next_s_ = cursor.segment_start();
  left_mm_ = lengths_.cut_mm + counted_mm;
}

}  // namespace stanok::motion
