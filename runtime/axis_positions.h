// Where the axes of a machine stand, out of the outputs of its channels.
#pragma once

#include <vector>

#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"

namespace stanok::runtime {

// Setpoints of all axes of the machine, in their order, M. An axis of several channels is where
// the channel has it that moves it now; an axis of none is at its start.
[[nodiscard]] std::vector<double> positions_of_axes(const channels::MachineConfig& machine,
                                                    const channels::CycleOutput& output);

}  // namespace stanok::runtime
