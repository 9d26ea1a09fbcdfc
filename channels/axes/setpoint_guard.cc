#include "channels/axes/setpoint_guard.h"

#include <cmath>

#include "motion/bounds/limit_guard.h"

namespace stanok::channels {
namespace {

bool is_number(const kinematics::Jet& jet) RT_SAFE {
  return std::isfinite(jet.value) && std::isfinite(jet.first) && std::isfinite(jet.second) &&
         std::isfinite(jet.third);
}

}  // namespace

std::optional<Fault> impossible_step(const motion::MotionConfig& motion, double cycle_s,
                                     const AxisGroup& axes, const motion::JetPoint& axes_M,
                                     Steps steps) RT_SAFE {
  constexpr double steps_allowed = 2.0;  // of the longest at the axis' highest velocity
  for (int axis = 0; axis < axes.count(); ++axis) {
    if (!axes.owns(axis)) continue;
    const double step = std::abs(axes_M[axis].value - axes.setpoint(axis).position);
    const double step_max = steps_allowed * motion.axes[axis].velocity_max * cycle_s +
                            axes.constants(axis).codes.resolution;
    const bool may_step = steps == Steps::of_numbers || axes.is_spindle(axis);
    const bool has_number = is_number(axes_M[axis]);
    if (has_number && (step <= step_max || may_step)) continue;
    Fault fault{{"A9002"}, {"axis "}};
    fault.text.append(axes.name(axis).view())
        .append(has_number ? " would move farther in one cycle than it can"
                           : " would get a setpoint that is not a number");
    return fault;
  }
  return std::nullopt;
}

std::optional<Fault> passed_limit(const motion::MotionConfig& motion, double cycle_s,
                                  const AxisGroup& axes, const motion::JetPoint& axes_M) RT_SAFE {
  for (int axis = 0; axis < axes.count(); ++axis) {
    if (!axes.owns(axis) || axes.is_spindle(axis)) continue;
    const double slack =
        axes.constants(axis).codes.resolution + std::abs(axes_M[axis].first) * cycle_s;
    if (!motion::passes_limit(axes_M[axis], motion.axes[axis], slack)) continue;
    Fault fault{{"A2003"}, {"axis "}};
    fault.text.append(axes.name(axis).view())
        .append(" is too close to its soft limit to stop before it");
    return fault;
  }
  return std::nullopt;
}

}  // namespace stanok::channels
