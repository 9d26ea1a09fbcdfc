#include "runtime/axis_positions.h"

#include <algorithm>

namespace stanok::runtime {

std::vector<double> positions_of_axes(const channels::MachineConfig& machine,
                                      const channels::CycleOutput& output) {
  std::vector<double> positions;
  positions.reserve(machine.axes.size());
  for (const channels::AxisConfig& axis : machine.axes) positions.push_back(axis.start);
  std::vector<bool> is_known(positions.size(), false);
  const auto end = output.channels.begin() + output.channel_count;
  for (const channels::ChannelConfig& config : machine.channels) {
    const auto channel = std::find_if(output.channels.begin(), end,
                                      [&](const auto& c) { return c.id == config.id; });
    if (channel == end) continue;
    for (std::size_t k = 0; k < config.axes.size(); ++k) {
      const auto axis = static_cast<std::size_t>(config.axes[k]);
      if (is_known[axis] && !channel->drives[k].enabled) continue;
      positions[axis] = channel->axes[k].position;
      is_known[axis] = true;
    }
  }
  return positions;
}

}  // namespace stanok::runtime
