#include "motion/profile/speed_segment.h"

#include <algorithm>

#include "motion/path/geometry.h"

namespace stanok::motion {

SpeedSegment speed_segment(const Segment& segment, double part) RT_SAFE {
  constexpr double speed_max = 1e6;
  constexpr double acceleration_max = 1e9;
  constexpr double jerk_max = 1e12;
  const SegmentLimits limits = segment_limits(segment.bounds, part * segment.feed_per_s);
  return {.length = segment.length,
          .v = std::min(limits.v, speed_max),
          .ramp = {.a = std::min(limits.a, acceleration_max), .j = std::min(limits.j, jerk_max)}};
}

}  // namespace stanok::motion
