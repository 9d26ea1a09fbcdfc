// MotionConfig of one channel, its axes in the channel's order.
#include "channels/contract/motion_config.h"

#include <algorithm>

namespace stanok::channels {

std::array<int, 3> geometry_axes(const ChannelConfig& channel) {
  const auto index_of = [&](const char* word) {
    const auto found = std::ranges::find(channel.words, word);
    return found == channel.words.end() ? -1 : static_cast<int>(found - channel.words.begin());
  };
  return {index_of("X"), index_of("Y"), index_of("Z")};
}

motion::MotionConfig motion_config(const MachineConfig& machine, const ChannelConfig& channel) {
  motion::MotionConfig config;
  config.axis_count = static_cast<int>(channel.axes.size());
  for (std::size_t index = 0; index < channel.axes.size(); ++index) {
    const AxisConfig& axis = machine.axes[channel.axes[index]];
    config.axes[index] = axis.limits;
    config.axes[index].linear = !axis.rotary;
  }
  config.geometry = geometry_axes(channel);
  config.cycle_s = machine.cycle_us * 1e-6;
  config.path_tolerance_mm = channel.path_tolerance_mm;
  config.orientation_tolerance_deg = channel.orientation_tolerance_deg;
  return config;
}

}  // namespace stanok::channels
