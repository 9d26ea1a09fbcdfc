// What a segment allows along itself: speed, and for any speed up to it tangential acceleration and
// jerk.
#pragma once

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

struct SpeedSegment {
  double length = 0.0;
  double v = 0.0;
  RampLimits ramp{};
};

// What a path segment allows when its feed is taken `part` times. Always finite, also where the
// machine file leaves an axis unlimited.
[[nodiscard]] SpeedSegment speed_segment(const Segment& segment, double part) RT_SAFE;

// The same speed with what a stop may use of the limits of every axis, 1 or more, for its ramps.
[[nodiscard]] SpeedSegment speed_segment_of_stop(const Segment& segment, double part,
                                                 double stop_limits) RT_SAFE;

}  // namespace stanok::motion
