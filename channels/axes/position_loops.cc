#include "channels/axes/position_loops.h"

#include <algorithm>

namespace stanok::channels {

PositionLoops::PositionLoops(const ChannelFigures& figures) : figures_(figures) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(figures.axis_count); ++k) {
    const AxisFigures& axis = figures.axes[k];
    if (axis.regulator.feedback == FeedbackPlace::cycle)
      regulators_[k] = motion::PositionRegulator(axis.regulator.gains, axis.demand_max);
  }
}

void PositionLoops::advance(const motion::JetPoint& axes_M, const DriveGuard& drives,
                            AxisGroup& axes) RT_SAFE {
  for (int axis = 0; axis < axes.count(); ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const RegulatorConfig& config = axes.figure(axis).regulator;
    const AxisFeedback& drive = drives.feedback(axis);
    if (config.feedback == FeedbackPlace::drive) {
      axes.demand_velocity(axis, axes.setpoint(axis).velocity);
    } else if (axes.drive(axis).enabled && drive.enabled) {
      const double held_s = std::max(config.demand_held_s, figures_.cycle_s);
      const motion::SetpointRates coming = motion::coming_rates(axes_M[k], held_s);
      axes.demand_velocity(axis, regulators_[k].demand(drive.setpoint - drive.position, coming));
    } else {
      regulators_[k].reset();
      axes.demand_velocity(axis, 0.0);
    }
  }
}

}  // namespace stanok::channels
