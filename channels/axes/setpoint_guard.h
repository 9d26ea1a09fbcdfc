// The last guards before a setpoint reaches a drive. Planning lets nothing pass that they find, so
// what they find is a fault of our own.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "channels/axes/drive_guard.h"
#include "motion/path/path.h"

namespace stanok::channels {

// Whether the positions of a cycle are steps of the axes or, as where homing names a position anew,
// of their numbers only.
enum class Steps : std::uint8_t { of_axes, of_numbers };

// An axis whose setpoint would be no number, or that would step farther than it can move in a
// cycle (A9002).
[[nodiscard]] std::optional<Fault> impossible_step(const motion::MotionConfig& motion,
                                                   double cycle_s, const AxisGroup& axes,
                                                   const motion::JetPoint& axes_M, Steps steps)
    RT_SAFE;

// An axis that comes too near to its soft limit to stand before it (A2003;
// motion/bounds/limit_guard.h).
[[nodiscard]] std::optional<Fault> passed_limit(const motion::MotionConfig& motion, double cycle_s,
                                                const AxisGroup& axes,
                                                const motion::JetPoint& axes_M) RT_SAFE;

}  // namespace stanok::channels
