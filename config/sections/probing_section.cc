// The keys of [[simulation.tool]] and [simulation.tool_setter] and their checks.
#include "config/sections/probing_section.h"

#include <algorithm>

namespace stanok::config {
namespace {

constexpr std::string_view as_table = "as in the tables";

const Keys<RealTool>& real_tool_keys() {
  static const Keys<RealTool> keys = {
      {"number", at<&RealTool::number>, required, "", "number of a tool of the tables file",
       from(1, 32000)},
      {"edge", at<&RealTool::edge>, optional, "", "number of its cutting edge", from(1, 99)},
      {"length", at<&RealTool::length>, optional, "mm", "from the spindle nose to the tip, along Z",
       any, as_table},
      {"length_x", at<&RealTool::length_x>, optional, "mm", "from the nose to the tip, along X",
       any, as_table},
      {"length_y", at<&RealTool::length_y>, optional, "mm", "from the nose to the tip, along Y",
       any, as_table},
      {"radius", at<&RealTool::radius>, optional, "mm", "radius of the cutter, or of the ball",
       positive, as_table},
  };
  return keys;
}

const Keys<ToolSetterConfig>& tool_setter_keys() {
  using C = ToolSetterConfig;
  static const Keys<C> keys = {
      {"channel", at<&C::channel>, required, "", "channel whose probe_input it switches",
       from(1, 99)},
      {"x", at<&C::x>, required, "mm",
       "middle of its upper face: reading of X with the spindle nose there"},
      {"y", at<&C::y>, required, "mm", "the same for Y"},
      {"z", at<&C::z>, required, "mm", "the same for Z"},
      {"diameter", at<&C::diameter>, required, "mm", "diameter of the disc", positive},
      {"height", at<&C::height>, optional, "mm", "height of the disc", positive},
  };
  return keys;
}

}  // namespace

std::vector<RealTool> read_real_tools(Subtables tools, const channels::MachineConfig& machine,
                                      const Scope& scope) {
  std::vector<RealTool> read;
  if (tools == nullptr) return read;
  for (const toml::node& node : *tools) {
    const toml::table& table = *node.as_table();
    const Scope inner = scope.inner("tool " + std::to_string(table["number"].value_or(0)));
    RealTool tool;
    read_table(table, real_tool_keys(), tool, inner);
    const bool is_known =
        std::ranges::any_of(machine.tables.tools, [&](const channels::ToolEdge& edge) {
          return edge.number == tool.number && edge.edge == tool.edge;
        });
    if (!is_known) {
      inner.fault(place_of(table, "number"),
                  "the tables file has no such tool and edge; give it a [[tool]] there");
    }
    read.push_back(tool);
  }
  return read;
}

ToolSetterConfig read_tool_setter(const toml::table& table, const channels::MachineConfig& machine,
                                  const Scope& scope) {
  ToolSetterConfig setter;
  read_table(table, tool_setter_keys(), setter, scope);
  const auto channel =
      std::ranges::find(machine.channels, setter.channel, &channels::ChannelConfig::id);
  if (channel == machine.channels.end() || channel->probe_input < 0) {
    scope.fault(place_of(table, "channel"), "channel " + std::to_string(setter.channel) +
                                                " has no probe_input; add one to the channel");
  }
  return setter;
}

std::vector<KeyRow> real_tool_key_rows() {
  return describe(real_tool_keys());
}

std::vector<KeyRow> tool_setter_key_rows() {
  return describe(tool_setter_keys());
}

}  // namespace stanok::config
