// What the motion of one channel needs of the machine file: limits, geometry axes, tolerances.
#pragma once

#include "channels/contract/machine_config.h"
#include "motion/path/path.h"

namespace stanok::channels {

// The channel axes that programs call X, Y, Z: the workpiece space of planes, arcs, path length and
// tolerance. Indices in the channel; -1: none.
[[nodiscard]] std::array<int, 3> geometry_axes(const ChannelConfig& channel);

[[nodiscard]] motion::MotionConfig motion_config(const MachineConfig& machine,
                                                 const ChannelConfig& channel);

}  // namespace stanok::channels
