// What the axes allow along a section of a chain that a spindle leads, as limits of ramps. Plain
// values; pure.
#pragma once

#include "motion/path/path.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

[[nodiscard]] inline RampLimits limits_of(const SpindleCoupling::Section& section) RT_SAFE {
  return {section.acceleration_max, section.jerk_max};
}

}  // namespace stanok::motion
