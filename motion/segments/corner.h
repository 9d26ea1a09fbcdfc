// What becomes of the join between two blocks: passed as it is, blended, or a stop.
//
// Which of the last two is faster depends on the limits: a blend saves the full stop but must be
// passed slowly over its whole length. docs/developer/motion.md#blends.
#pragma once

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

// Whether the blend, whose bounds are known, is passed nearly as fast as the feed or the length of
// the blocks allow, so that the time need not be asked for.
[[nodiscard]] bool keeps_speed(const Segment& incoming, const Segment& blend,
                               const Segment& outgoing, const MotionConfig& config);

// Whether the axes come through sooner when they stop at the corner instead of taking `blend`.
// Ramps are counted at the limits of either block, within half of its
// length. The stop is shorter by `stop_saves` (s) than one without an overlap.
[[nodiscard]] bool is_stop_faster(const Segment& incoming, const Segment& blend,
                                  const Segment& outgoing, double stop_saves,
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
