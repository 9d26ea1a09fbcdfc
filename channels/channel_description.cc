// ChannelDescription of one channel, its axes in the channel's order.
#include "channels/channel_description.h"

#include "channels/motion_config.h"

namespace stanok::channels {

lang::ChannelDescription channel_description(const MachineConfig& machine,
                                             const ChannelConfig& channel) {
  lang::ChannelDescription description;
  description.id = channel.id;
  description.name = channel.name;
  description.kind = channel.kind;
  description.spindles = channel.spindles;
  description.arc_radius_tolerance_mm = channel.arc_radius_tolerance_mm;
  for (std::size_t index = 0; index < channel.axes.size(); ++index) {
    const AxisConfig& axis = machine.axes[static_cast<std::size_t>(channel.axes[index])];
    description.axes.push_back(
        {.word = channel.words[index], .rotary = axis.rotary, .modulo_deg = axis.modulo_deg});
  }
  const std::array<int, 3> geometry = geometry_axes(channel);
  for (std::size_t k = 0; k < geometry.size(); ++k) {
    if (geometry[k] >= 0) {
      description.axes[static_cast<std::size_t>(geometry[k])].geometry = static_cast<int>(k);
    }
  }
  for (const ChannelConfig& any : machine.channels) {
    description.channels.push_back(any.id);
    for (const auto& scheme : any.schemes) description.schemes.emplace_back(any.id, scheme.id);
  }
  return description;
}

}  // namespace stanok::channels
