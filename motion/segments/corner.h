// What becomes of the join between two blocks: passed as it is, blended, or a stop.
//
// Which of the last two is faster depends on the limits: a blend saves the full stop but must be
// passed slowly over its whole length. docs/developer/motion.md#blends.
#pragma once

#include <span>

#include "motion/path/path.h"
#include "motion/segments/corner_overlap.h"

namespace stanok::motion {

enum class Join : std::uint8_t {
  smooth,  // tangent and curvature continue in all axes: the path passes as it is
  corner,  // to be blended
  turn,    // the path turns back on itself, or changes its metric: the axes must stop
};

// Judges the join at which `incoming` ends and `outgoing` starts.
[[nodiscard]] Join judge_join(const Segment& incoming, const Segment& outgoing);

// A curve through the corner: how fast it is passed at an even speed, and how long it is.
struct Passage {
  double v = 0.0;       // mm/s
  double feed = 0.0;    // mm/s; the most that is programmed there
  double length = 0.0;  // mm
};
// Of a curve in one or more segments, whose bounds are known, at `feed` (mm/s).
[[nodiscard]] Passage passage_of(std::span<const Segment> curve, double feed);

// Whether the curve is passed nearly as fast as the feed or the length of the blocks allow, so that
// the time need not be asked for.
[[nodiscard]] bool keeps_speed(const Segment& incoming, const Passage& curve,
                               const Segment& outgoing, const MotionConfig& config);

// Time lost (s) by passing the curve, and by a stop, against both legs at their top speed. Ramps
// are counted at the limits of either block, within half of its length.
[[nodiscard]] double time_lost(const Segment& incoming, const Passage& curve,
                               const Segment& outgoing, const MotionConfig& config);
[[nodiscard]] double time_lost_by_stop(const Segment& incoming, const Segment& outgoing,
                                       const MotionConfig& config);

// What an overlap saves against a stop, counted in the same way.
struct OverlapGain {
  double time = 0.0;  // s; <= 0: nothing
  // Part of its jerk that either leg uses for it. Where an axis goes on in the same direction the
  // jerks of both legs add; gentler ramps may gain more by the overlap than they cost.
  double jerk_part = 1.0;
};
[[nodiscard]] OverlapGain overlap_gain(const OverlapCorner& corner, const Segment& incoming,
                                       const Segment& outgoing, const MotionConfig& config);

}  // namespace stanok::motion
