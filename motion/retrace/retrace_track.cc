#include "motion/retrace/retrace_track.h"

namespace stanok::motion {

void RetraceTrack::begin(const Segment* held, double way) RT_SAFE {
  constexpr double rounding = 1e-9;  // mm: not worth a piece
  has_held_ = held != nullptr && way > rounding;
  if (!has_held_) return;
  held_ = *held;
  held_.process = {};
  way_ = way;
}

RetraceTrack::Place RetraceTrack::before(Place place) const RT_SAFE {
  return has_held_ && place == last() ? history_.newest() : history_.before(place);
}

RetraceTrack::Place RetraceTrack::behind(Place place) const RT_SAFE {
  return is_held(place) ? last() : history_.behind(place);
}

void RetraceTrack::read(Place place, TrackPiece& piece) const RT_SAFE {
  if (is_held(place)) {
    piece = {.passed = {.segment = held_, .begins_chain = history_.rests()}, .length = way_};
    return;
  }
  history_.read(place, piece.passed);
  piece.length = piece.segment().length;
}

std::uint64_t RetraceTrack::blocks_up_to(Place place) const RT_SAFE {
  if (!is_held(place)) return history_.blocks_between(first(), behind(place));
  const bool is_of_newest = !history_.is_empty() && history_.is_of_newest_block(held_.tag);
  return history_.blocks_between(first(), place) + (is_of_newest ? 0 : 1);
}

}  // namespace stanok::motion
