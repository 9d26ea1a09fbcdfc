// Evaluation of a segment's geometry: position and derivatives along the path, exact at both ends.
#pragma once

#include "motion/path/path.h"

namespace stanok::motion {

// The programmed point and its first three derivatives with respect to the segment's own path
// length, at `s` in [0, length]. s <= 0 returns the stored start and s >= length the stored end to
// the bit. |d(xyz)/ds| = 1 to rounding, whatever the error of u(s).
void evaluate(const Segment& segment, double s, JetPoint& point_s) RT_SAFE;

// The same at the geometry's own parameter u in [0, 1]: equal steps of u are not equal steps of s.
void evaluate_at_parameter(const Segment& segment, double u, JetPoint& point_s) RT_SAFE;

// Replaces derivatives by s with derivatives by time: s(t) moves with v, a, j (mm/s...).
void along_time(const JetPoint& point_s, double v, double a, double j, int axis_count,
                JetPoint& point_t) RT_SAFE;

// The fastest path speed that the segment allows on its own, with room left for tangential
// acceleration and jerk (docs/developer/motion.md#bounds).
struct SegmentLimits {
  double v = 0.0;  // mm/s
  double a = 0.0;  // mm/s^2, tangential, for any speed up to v
  double j = 0.0;  // mm/s^3
};
// `feed_per_s`: cap of v before the rest is distributed; infinity = what the axes allow. v, a and j
// are positive and finite.
[[nodiscard]] SegmentLimits segment_limits(const SegmentBounds& bounds, double feed_per_s) RT_SAFE;

}  // namespace stanok::motion
