#include "channels/live_tables.h"

#include <algorithm>

namespace stanok::channels {
namespace {

constexpr int work_offsets_max = 9 + 300;  // G54..G59.3 and G54.1 P1..P300
constexpr int tools_without_row_max = 99;  // present with length 0 and radius 0

}  // namespace

std::string work_offset_name(int number) {
  if (number <= 6) return "G" + std::to_string(53 + number);
  if (number <= 9) return "G59." + std::to_string(number - 6);
  return "G54.1 P" + std::to_string(number - 9);
}

LiveTables::LiveTables(const TablesConfig& initial) : tables_(initial) {}

std::optional<double> LiveTables::offset(int number, const std::string& axis) const {
  if (number < 1 || number > work_offsets_max) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const auto row = tables_.offsets.find(work_offset_name(number));
  if (row == tables_.offsets.end()) return 0.0;
  const auto value = row->second.find(axis);
  return value == row->second.end() ? 0.0 : value->second;
}

std::optional<ToolEdge> LiveTables::tool(int number, int edge) const {
  const std::lock_guard lock(mutex_);
  const auto row = std::find_if(
      tables_.tools.begin(), tables_.tools.end(),
      [&](const ToolEdge& tool) { return tool.number == number && tool.edge == edge; });
  if (row != tables_.tools.end()) return *row;
  if (number < 0 || number > tools_without_row_max || edge != 1) return std::nullopt;
  ToolEdge plain;
  plain.number = number;
  return plain;
}

TablesConfig LiveTables::snapshot() const {
  const std::lock_guard lock(mutex_);
  return tables_;
}

ChannelTables::ChannelTables(const LiveTables& live, const MachineConfig& machine,
                             const ChannelConfig& channel)
    : live_(live) {
  for (const int axis : channel.axes)
    axis_names_.push_back(machine.axes[static_cast<std::size_t>(axis)].name);
}

std::optional<lang::AxisValues> ChannelTables::work_offset(int number) const {
  lang::AxisValues values{};
  for (std::size_t k = 0; k < axis_names_.size(); ++k) {
    const auto value = live_.offset(number, axis_names_[k]);
    if (!value) return std::nullopt;
    values[k] = *value;
  }
  return values;
}

// Beside the axes of its row, under the word of G10 L2.
double ChannelTables::work_offset_rotation(int number) const {
  return live_.offset(number, "R").value_or(0.0);
}

std::optional<lang::Tool> ChannelTables::tool(int number) const {
  const auto edge = live_.tool(number, 1);
  if (!edge) return std::nullopt;
  lang::Tool tool;
  tool.number = number;
  tool.length_mm = {edge->length_x, edge->length_y, edge->length + edge->wear_length};
  tool.radius_mm = edge->radius + edge->wear_radius;
  tool.orientation = edge->orientation;
  return tool;
}

}  // namespace stanok::channels
