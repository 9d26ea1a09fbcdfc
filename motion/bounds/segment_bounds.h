// What a segment asks of the machine axes: bounds of the derivatives, and the range of positions.
//
// Lines and arcs whose transform only shifts and turns have closed forms. All others are sampled
// over their parameter; what may lie between samples is bounded by second differences, and sampling
// is refined until that margin is small. docs/developer/motion.md#bounds.
#pragma once

#include <optional>

#include "motion/path/path.h"

namespace stanok::motion {

// Bounds over all axes of the machine; a rapid segment keeps the rapid speed of each axis too.
[[nodiscard]] SegmentBounds segment_bounds(const Segment& segment, const MotionConfig& config);

// A machine axis beyond its soft limit, or a pose that does not exist (position is NaN).
struct Excess {
  int axis = 0;
  double position = 0.0;
  double limit = 0.0;
};
// The farthest excess over the whole segment, extremes between its ends included. Limits are
// touched freely: an excess below 1e-9 mm or deg is rounding.
[[nodiscard]] std::optional<Excess> soft_limit_excess(const Segment& segment,
                                                      const MotionConfig& config);

}  // namespace stanok::motion
