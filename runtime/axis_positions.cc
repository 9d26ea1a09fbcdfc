#include "runtime/axis_positions.h"

#include "base/place.h"

namespace stanok::runtime {

std::vector<double> positions_of_axes(const channels::MachineConfig& machine,
                                      const channels::CycleOutput& output) {
  std::vector<double> positions;
  positions.reserve(machine.axes.size());
  for (const channels::AxisConfig& axis : machine.axes) positions.push_back(axis.start);
  std::vector<bool> is_known(positions.size(), false);
  for (const channels::ChannelConfig& config : machine.channels) {
    const channels::ChannelOutput* const channel = output.of_channel(config.id);
    if (channel == nullptr) continue;
    for (std::size_t k = 0; k < config.axes.size(); ++k) {
      const std::size_t axis = checked_size(config.axes[k]);
      if (is_known[axis] && !channel->drives[k].enabled) continue;
      positions[axis] = channel->axes[k].position;
      is_known[axis] = true;
    }
  }
  return positions;
}

}  // namespace stanok::runtime
