// ChannelDescription of one channel, its axes in the channel's order.
#include "channels/contract/channel_description.h"

#include <algorithm>

#include "channels/contract/motion_config.h"
#include "lang/words/channel_dialect.h"

namespace stanok::channels {
namespace {

// The spindle of the channel that becomes this axis; 0: none.
int spindle_of_axis(const MachineConfig& machine, const ChannelConfig& channel,
                    const std::string& axis) {
  for (const SpindleConfig& spindle : machine.spindles) {
    const bool is_own = std::find(channel.spindles.begin(), channel.spindles.end(), spindle.id) !=
                        channel.spindles.end();
    if (is_own && spindle.axis == axis) return spindle.id;
  }
  return 0;
}

// The smallest step of the channel's linear axes, mm; 0 without one.
double finest_resolution(const MachineConfig& machine, const ChannelConfig& channel) {
  double finest = 0.0;
  for (const int index : channel.axes) {
    const AxisConfig& axis = machine.axes[index];
    if (axis.rotary || axis.resolution <= 0.0) continue;
    finest = finest == 0.0 ? axis.resolution : std::min(finest, axis.resolution);
  }
  return finest;
}

}  // namespace

lang::ChannelDescription channel_description(const MachineConfig& machine,
                                             const ChannelConfig& channel) {
  lang::ChannelDescription description;
  description.id = channel.id;
  description.bounds = machine.program_bounds;
  description.name = channel.name;
  description.kind = channel.kind;
  description.rules = channel.rules;
  description.spindles = channel.spindles;
  for (const SpindleConfig& spindle : machine.spindles) {
    if (spindle.encoder_pulses > 0) description.spindles_with_position.push_back(spindle.id);
  }
  description.plain_corners = channel.plain_corners;
  description.has_force_control = channel.force_control;
  description.tool_word_changes_tool = channel.tool_change == "t_word";
  description.tool_word_has_edge = channel.t_format == "tool_edge";
  description.tool_word_has_offset = channel.t_format == "tool_offset";
  description.arc_radius_tolerance_mm = channel.arc_radius_tolerance_mm;
  description.tool_measuring = channel.tool_measuring;
  for (std::size_t index = 0; index < channel.axes.size(); ++index) {
    const AxisConfig& axis = machine.axes[channel.axes[index]];
    description.axes.push_back({.word = channel.words[index],
                                .rotary = axis.rotary,
                                .modulo_deg = axis.modulo_deg,
                                .spindle = spindle_of_axis(machine, channel, axis.name)});
  }
  description.finest_resolution_mm = finest_resolution(machine, channel);
  const std::array<int, 3> geometry = geometry_axes(channel);
  for (std::size_t k = 0; k < geometry.size(); ++k) {
    if (geometry[k] >= 0) {
      description.axes[geometry[k]].geometry = static_cast<int>(k);
    }
  }
  for (const auto& [code, meaning] : channel.codes) {
    if (const auto read = lang::read_user_code(code, meaning)) {
      description.user_codes.push_back(*read);
    }
  }
  for (const auto& [letter, address] : channel.address_alias) {
    if (const auto read = lang::read_address_alias(letter, address, channel.kind, channel.words)) {
      description.address_alias.push_back(*read);
    }
  }
  for (const ChannelConfig& any : machine.channels) {
    description.channels.push_back(any.id);
    for (const auto& scheme : any.schemes) description.schemes.emplace_back(any.id, scheme.id);
  }
  return description;
}

std::optional<std::string> fault_of_code(std::string_view code, std::string_view meaning) {
  const auto read = lang::read_user_code(code, meaning);
  return read ? std::nullopt : std::optional(read.error());
}

std::optional<std::string> fault_of_alias(std::string_view letter, std::string_view address,
                                          const ChannelConfig& channel) {
  const auto read = lang::read_address_alias(letter, address, channel.kind, channel.words);
  return read ? std::nullopt : std::optional(read.error());
}

}  // namespace stanok::channels
