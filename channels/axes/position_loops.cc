#include "channels/axes/position_loops.h"

#include <algorithm>

namespace stanok::channels {

PositionLoops::PositionLoops(const ChannelConstants& constants) : constants_(constants) {
  for (int k = 0; k < constants.axis_count; ++k) {
    const AxisConstants& axis = constants.axes[k];
    if (axis.controller.feedback == FeedbackPlace::cycle)
      controllers_[k] = motion::PositionController(axis.controller.gains, axis.demand_max);
  }
}

void PositionLoops::advance(const motion::JetPoint& axes_M, const DriveGuard& drives,
                            AxisGroup& axes) RT_SAFE {
  for (int axis = 0; axis < axes.count(); ++axis) {
    const ControllerConfig& config = axes.constants(axis).controller;
    const AxisFeedback& drive = drives.feedback(axis);
    if (config.feedback == FeedbackPlace::drive) {
      axes.demand_velocity(axis, axes.setpoint(axis).velocity);
    } else if (axes.drive(axis).enabled && drive.enabled) {
      const double held_s = std::max(config.demand_held_s, constants_.cycle_s);
      const motion::SetpointRates coming = motion::coming_rates(axes_M[axis], held_s);
      axes.demand_velocity(axis,
                           controllers_[axis].demand(drive.setpoint - drive.position, coming));
    } else {
      controllers_[axis].reset();
      axes.demand_velocity(axis, 0.0);
    }
  }
}

}  // namespace stanok::channels
