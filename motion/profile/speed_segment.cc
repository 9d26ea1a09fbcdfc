#include "motion/profile/speed_segment.h"

#include <algorithm>

#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

SpeedSegment finite(const Segment& segment, const SegmentLimits& limits) RT_SAFE {
  constexpr double speed_max = 1e6;
  constexpr double acceleration_max = 1e9;
  constexpr double jerk_max = 1e12;
  return {.length = segment.length,
          .v = std::min(limits.v, speed_max),
          .ramp = {.a = std::min(limits.a, acceleration_max), .j = std::min(limits.j, jerk_max)}};
}

// Of axes with so many times their acceleration and jerk.
SegmentBounds eased(const SegmentBounds& bounds, double times) RT_SAFE {
  SegmentBounds eased = bounds;
  for (double* const bound : {&eased.tangent, &eased.thrust, &eased.curvature, &eased.bend,
                              &eased.aberrancy, &eased.euclidean.tangent, &eased.euclidean.thrust,
                              &eased.euclidean.curvature, &eased.euclidean.bend})
    *bound /= times;
  return eased;
}

}  // namespace

SpeedSegment speed_segment(const Segment& segment, double part) RT_SAFE {
  return finite(segment, segment_limits(segment.bounds, part * segment.feed_per_s));
}

SpeedSegment speed_segment_of_stop(const Segment& segment, double part, double stop_limits)
    RT_SAFE {
  const double v = speed_segment(segment, part).v;
  return finite(segment, segment_limits(eased(segment.bounds, stop_limits), v));
}

}  // namespace stanok::motion
