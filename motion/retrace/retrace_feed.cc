#include "motion/retrace/retrace_feed.h"

namespace stanok::motion {

void RetraceFeed::begin(RetraceWay way, RetraceTrack::Place place) RT_SAFE {
  way_ = way;
  place_ = place;
  chunk_ = {};
}

bool RetraceFeed::is_done() const RT_SAFE {
  return place_ == (way_ == RetraceWay::back ? track_.first() : track_.last());
}

void RetraceFeed::advance() RT_SAFE {
  for (int k = 0; k < pieces_per_cycle; ++k) {
    if (is_done() || queue_.segments.space() == 0 || queue_.chunks.space() == 0) return;
    lay_next();
  }
}

void RetraceFeed::lay_next() RT_SAFE {
  if (way_ == RetraceWay::back) place_ = track_.before(place_);
  track_.read(place_, piece_);
  if (way_ == RetraceWay::forward) place_ = track_.behind(place_);
  Segment& segment = piece_.passed.segment;
  segment.length = piece_.length;
  if (!queue_.segments.push(segment)) return;  // there is room for it
  chunk_.length += segment.length;
  ++chunk_.segments;
  const bool rests = way_ == RetraceWay::back ? piece_.passed.begins_chain
                                              : piece_.passed.place == ChainPlace::last;
  chunk_.last = rests || is_done();
  if (!chunk_.last && chunk_.segments < chunk_segments) return;
  if (queue_.chunks.push(chunk_)) chunk_ = {};
}

}  // namespace stanok::motion
