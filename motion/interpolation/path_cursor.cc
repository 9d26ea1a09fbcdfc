#include "motion/interpolation/path_cursor.h"

#include <algorithm>

namespace stanok::motion {

void PathCursor::enter(PathQueue& queue) RT_SAFE {
  has_chunk_ = queue.chunks.pop(chunk_);
  segments_left_ = chunk_.segments;
  phases_left_ = chunk_.phases;
  segment_start_ = 0.0;
}

void PathCursor::leave(PathQueue& queue) RT_SAFE {
  note_rest(queue);
  queue.segments.pop_front(segments_left_);
  queue.phases.pop_front(phases_left_);
  segment_number_ += segments_left_;
  segments_left_ = 0;
  phases_left_ = 0;
  has_chunk_ = false;
}

void PathCursor::note(const PathQueue& queue, std::size_t index, ChainPlace place) RT_SAFE {
  if (history_ != nullptr) history_->note(queue.segments[index], place);
}

// The axes do not go back along what a spindle led.
void PathCursor::note_rest(const PathQueue& queue) RT_SAFE {
  for (std::size_t k = 0; k < segments_left_; ++k) {
    const bool is_last = chunk_.last && k + 1 == segments_left_;
    note(queue, k, is_last ? ChainPlace::last : ChainPlace::within);
  }
  if (history_ != nullptr && chunk_.coupling.kind != SpindleCoupling::Kind::none) history_->cut();
}

void PathCursor::drop(PathQueue& queue) RT_SAFE {
  if (history_ != nullptr) history_->cut();
  segment_number_ += queue.segments.size();
  queue.chunks.pop_front(queue.chunks.size());
  queue.segments.pop_front(queue.segments.size());
  queue.phases.pop_front(queue.phases.size());
  segments_left_ = 0;
  phases_left_ = 0;
  has_chunk_ = false;
}

void PathCursor::go_to(PathQueue& queue, double s, std::uint64_t closed_from_block) RT_SAFE {
  while (segments_left_ > 1 && s >= segment_start_ + queue.segments.front().length &&
         queue.segments[1].tag.block < closed_from_block) {
    segment_start_ += queue.segments.front().length;
    note(queue, 0, ChainPlace::within);
    queue.segments.pop_front();
    --segments_left_;
    ++segment_number_;
  }
}

double PathCursor::s_in_segment(const PathQueue& queue, double s) const RT_SAFE {
  const double length = queue.segments.front().length;
  if (segments_left_ == 1 && s >= chunk_.length) return length;
  return std::clamp(s - segment_start_, 0.0, length);
}

void PathCursor::pass_phase(PathQueue& queue) RT_SAFE {
  queue.phases.pop_front();
  --phases_left_;
}

std::uint32_t PathCursor::segments_seen(const PathQueue& queue) const RT_SAFE {
  if (chunk_.last || queue.chunks.empty()) return segments_left_;
  return segments_left_ + queue.chunks.front().segments;
}

}  // namespace stanok::motion
