// PositionLoops: the velocities that the drives of a channel's axes are asked for.
//
// A drive that closes its position loop itself is told the velocity of the setpoint; one whose
// loop is closed in the cycle gets what its controller makes of the following error. Thread: the
// real-time cycle. Owner: the channel. Invariant: the controller of an axis that its drive does not
// hold is reset, so that it begins anew when the drive takes the axis over.
#pragma once

#include "base/axis_index.h"
#include "base/rt_safe.h"
#include "channels/axes/axis_group.h"
#include "channels/axes/drive_guard.h"
#include "motion/threads/position_controller.h"

namespace stanok::channels {

class PositionLoops {
 public:
  // `constants` outlive the loops.
  explicit PositionLoops(const ChannelConstants& constants);

  // Behind the setpoints of the cycle; `axes_M` with their derivatives.
  void advance(const motion::JetPoint& axes_M, const DriveGuard& drives, AxisGroup& axes) RT_SAFE;

 private:
  const ChannelConstants& constants_;
  AxisArray<motion::PositionController> controllers_{};
};

}  // namespace stanok::channels
