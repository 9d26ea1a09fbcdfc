// RetraceFeed: lays the pieces of a track into a queue, in the direction in which they are to be
// run, as fast as a cycle may.
//
// What it lays are lengths, bounds and feeds: which way a piece is run makes no difference to
// those. Pieces between two rests are a chain, in chunks. Thread: the cycle. Owner: the retrace.
#pragma once

#include <cstddef>

#include "base/rt_safe.h"
#include "motion/path/path_queue.h"
#include "motion/retrace/retrace_track.h"

namespace stanok::motion {

enum class RetraceWay : std::uint8_t { back, forward };

class RetraceFeed {
 public:
  // `track` outlives the feed.
  explicit RetraceFeed(const RetraceTrack& track) : track_(track), queue_(4 * chunk_segments) {}

  // Lays pieces from `place` on; the queue is empty.
  void begin(RetraceWay way, RetraceTrack::Place place) RT_SAFE;
  // Once a cycle.
  void advance() RT_SAFE;

  [[nodiscard]] PathQueue& queue() RT_SAFE { return queue_; }
  // The pieces up to the end of the track have been laid.
  [[nodiscard]] bool is_done() const RT_SAFE;

 private:
  static constexpr std::size_t chunk_segments = 512;
  static constexpr int pieces_per_cycle = 64;

  void lay_next() RT_SAFE;

  const RetraceTrack& track_;
  PathQueue queue_;
  RetraceWay way_ = RetraceWay::back;
  RetraceTrack::Place place_ = 0;  // how far it has come
  Chunk chunk_;                    // that is being laid
  TrackPiece piece_;
};

}  // namespace stanok::motion
