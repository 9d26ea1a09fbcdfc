// A kinematic scheme, in its own file or inside [[channel.scheme]] of the machine file.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "base/axis_index.h"
#include "channels/contract/machine_config.h"
#include "config/text/key_table.h"
#include "kinematics/scheme.h"

namespace stanok::config {

// The axes of the channel a scheme belongs to, in the channel's order.
struct ChannelAxes {
  std::span<const std::string> words;
  AxisList<const channels::AxisConfig*> axes;
  std::vector<bool> is_shared;  // another channel has the axis, too

  // Index of the axis that programs or the machine call `name`; words come first. -1: none.
  [[nodiscard]] int find(std::string_view name) const;
  [[nodiscard]] std::string list() const;  // "X, Y, Z"
};

// All schemes of a channel in the order of the file; scheme files are looked for in `folder`.
[[nodiscard]] std::vector<kinematics::SchemeConfig> read_schemes(
    Subtables schemes, const ChannelAxes& axes, const std::filesystem::path& folder,
    const Scope& scope);

}  // namespace stanok::config
