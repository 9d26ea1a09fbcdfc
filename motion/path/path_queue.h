// The queue of committed path between preparation (producer) and cycle (consumer).
#pragma once

#include "base/ring.h"
#include "motion/path/path.h"

namespace stanok::motion {

struct PathQueue {
  // Two seconds of motion at 100 mm/s in blocks of 5 um, 48 MB.
  static constexpr std::size_t usual_capacity = 40960;

  explicit PathQueue(std::size_t segment_capacity = usual_capacity)
      : segments(segment_capacity), phases(segment_capacity * 4), chunks(256) {}
  Ring<Segment> segments;
  Ring<Phase> phases;
  Ring<Chunk> chunks;  // pushed last: a chunk in the ring has all its segments and phases in theirs

  // Consumer. It sees the first `count` chunks pushed since construction, and of segments and
  // phases what belongs to them.
  void show(std::size_t count) RT_SAFE {
    std::size_t place = chunks.shown() - chunks.popped();
    chunks.show(count);
    for (; place < chunks.size(); ++place) {
      shown_segments_ += chunks[place].segments;
      shown_phases_ += chunks[place].phases;
    }
    segments.show(shown_segments_);
    phases.show(shown_phases_);
  }

 private:
  std::size_t shown_segments_ = 0;  // since construction
  std::size_t shown_phases_ = 0;
};

}  // namespace stanok::motion
