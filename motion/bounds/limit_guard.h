// The last guard of the soft limits: from the state of an axis in the cycle, how far it goes until
// it can stand at the earliest.
//
// Planning lets no path through that would pass a limit. A motion that keeps limits of position,
// acceleration and jerk can always stand within the first, so the guard is silent wherever planning
// is right; it speaks when something else led the axis.
#pragma once

#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::motion {

// How far an axis goes on in positive direction from velocity `v` and acceleration `a` until it
// turns around at the earliest with -acceleration and -jerk as limits; 0 when it does not. All in
// mm or deg, s. Closed form of x'' -> -A by x''' = -J.
[[nodiscard]] double stopping_distance(double v, double a, double acceleration_max, double jerk_max)
    RT_SAFE;

// Whether the axis, which moves as `axis` says (mm or deg, s), cannot stand any more within its
// limits; `slack` (mm or deg) beyond them is let pass.
[[nodiscard]] bool passes_limit(const kinematics::Jet& axis, const AxisLimits& limits, double slack)
    RT_SAFE;

}  // namespace stanok::motion
