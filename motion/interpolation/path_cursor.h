// PathCursor: where the cycle stands in the queue of committed path.
//
// It enters chunks, walks over their segments and phases and gives what lies behind back to the
// producer. Path positions s count from the start of the current chunk; the chunk after it, when it
// belongs to the same chain and is in the queue, can be seen but not changed.
#pragma once

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/path/path_history.h"
#include "motion/path/path_queue.h"
#include "motion/profile/feed_control.h"

namespace stanok::motion {

class PathCursor {
 public:
  // `history`, which outlives the cursor, is told of what lies behind.
  explicit PathCursor(PathHistory* history = nullptr) : history_(history) {}

  // Enters the next chunk at its start; the queue must hold one, and there is no current chunk.
  void enter(PathQueue& queue) RT_SAFE;
  // Leaves the current chunk: all its segments and phases are given back.
  void leave(PathQueue& queue) RT_SAFE;
  // Leaves the whole path, what is queued included; its segments keep their numbers.
  void drop(PathQueue& queue) RT_SAFE;

  [[nodiscard]] bool has_chunk() const RT_SAFE { return has_chunk_; }
  [[nodiscard]] const Chunk& chunk() const RT_SAFE { return chunk_; }

  // The current segment and where it begins.
  [[nodiscard]] const Segment& segment(const PathQueue& queue) const RT_SAFE {
    return queue.segments.front();
  }
  [[nodiscard]] double segment_start() const RT_SAFE { return segment_start_; }
  // Goes on to the segment that contains s; a place between two segments belongs to the second. The
  // last segment of the chunk is kept, and the last one before a gate.
  void go_to(PathQueue& queue, double s, std::uint64_t closed_from_block = FeedControl::no_gate)
      RT_SAFE;
  // s within the current segment, exactly its length at the end of the chunk.
  [[nodiscard]] double s_in_segment(const PathQueue& queue, double s) const RT_SAFE;

  // Committed phases from the current one on.
  [[nodiscard]] bool has_phase() const RT_SAFE { return phases_left_ > 0; }
  [[nodiscard]] const Phase& phase(const PathQueue& queue) const RT_SAFE {
    return queue.phases.front();
  }
  void pass_phase(PathQueue& queue) RT_SAFE;
  [[nodiscard]] std::uint32_t phases_left() const RT_SAFE { return phases_left_; }

  // What can be seen from the current segment on: segments of this chunk and of the chain's next
  // one.
  [[nodiscard]] std::uint32_t segments_left() const RT_SAFE { return segments_left_; }
  [[nodiscard]] std::uint32_t segments_seen(const PathQueue& queue) const RT_SAFE;
  // Number of the current segment, counted over all chunks.
  [[nodiscard]] std::uint64_t segment_number() const RT_SAFE { return segment_number_; }

 private:
  void note(const PathQueue& queue, std::size_t index, ChainPlace place) RT_SAFE;
  void note_rest(const PathQueue& queue) RT_SAFE;

  PathHistory* history_;
  Chunk chunk_{};
  bool has_chunk_ = false;
  std::uint32_t segments_left_ = 0;
  std::uint32_t phases_left_ = 0;
  double segment_start_ = 0.0;
  std::uint64_t segment_number_ = 0;
};

}  // namespace stanok::motion
