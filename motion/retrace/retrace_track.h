// RetraceTrack: the pieces of path that lie behind a held path: the segments of the history, and
// the part of the current one that was passed.
//
// Pieces lie between places. Thread: the cycle. Owner: the retrace. Invariant: while a path is
// held, the history is not written.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/path/path_history.h"

namespace stanok::motion {

// One piece: how much of the segment was passed, and whether the axes rested at its ends.
struct TrackPiece {
  PassedSegment passed;
  double length = 0.0;

  [[nodiscard]] const Segment& segment() const RT_SAFE { return passed.segment; }
};

class RetraceTrack {
 public:
  using Place = PathHistory::Place;

  // `history` outlives the track.
  explicit RetraceTrack(const PathHistory& history) : history_(history) {}

  // The path is held `way` into `held`, or, nullptr, between two chains.
  void begin(const Segment* held, double way) RT_SAFE;

  [[nodiscard]] Place first() const RT_SAFE { return history_.oldest(); }
  [[nodiscard]] Place last() const RT_SAFE { return history_.newest() + (has_held_ ? 1 : 0); }
  [[nodiscard]] bool is_empty() const RT_SAFE { return first() == last(); }
  // Where the piece begins that ends at `place`, and where the one ends that begins there.
  [[nodiscard]] Place before(Place place) const RT_SAFE;
  [[nodiscard]] Place behind(Place place) const RT_SAFE;
  // The piece that begins there.
  void read(Place place, TrackPiece& piece) const RT_SAFE;
  // Up to the end of the piece that begins there.
  [[nodiscard]] std::uint64_t blocks_up_to(Place place) const RT_SAFE;

 private:
  [[nodiscard]] bool is_held(Place place) const RT_SAFE {
    return has_held_ && place == history_.newest();
  }

  const PathHistory& history_;
  Segment held_;
  double way_ = 0.0;
  bool has_held_ = false;
};

}  // namespace stanok::motion
