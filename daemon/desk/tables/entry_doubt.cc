#include "daemon/desk/tables/entry_doubt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "channels/contract/entry_bounds.h"
#include "daemon/report/inventory.h"

namespace stanok::daemon {
namespace {

using channels::EntryBound;
using channels::EntryBounds;
using channels::MachineConfig;
using channels::TablesConfig;
using channels::commands::OffsetSet;
using channels::commands::ToolSet;

constexpr std::string_view rotation = "R";

// "G54.1 P2 X" without the axis, and the axis.
std::string offset_of(const OffsetSet& command) {
  const std::string place(command.place.view());
  return place.substr(0, place.rfind(' '));
}
std::string axis_of_place(const OffsetSet& command) {
  const std::string place(command.place.view());
  return place.substr(place.rfind(' ') + 1);
}

int edge_of(const ToolSet& command) {
  return std::max(1, command.edge);
}

std::string name_of_entry(const ToolSet& command) {
  std::string name = "tool " + std::to_string(command.tool);
  if (edge_of(command) > 1) name += ", edge " + std::to_string(edge_of(command));
  return name + ", " + std::string(command.key.view());
}
std::string name_of_entry(const OffsetSet& command) {
  return std::string(command.place.view());
}

std::optional<double> value_at(const TablesConfig& tables, const ToolSet& place) {
  const auto row = std::ranges::find_if(tables.tools, [&](const channels::ToolEdge& tool) {
    return tool.number == place.tool && tool.edge == edge_of(place);
  });
  if (row == tables.tools.end()) return std::nullopt;
  const nlohmann::json values = tool_json(*row);
  const auto value = values.find(place.key.view());
  return value != values.end() && value->is_number() ? std::optional(value->get<double>())
                                                     : std::nullopt;
}

std::optional<double> value_at(const TablesConfig& tables, const OffsetSet& place) {
  const auto row = tables.offsets.find(offset_of(place));
  if (row == tables.offsets.end()) return 0.0;
  const auto value = row->second.find(axis_of_place(place));
  return value == row->second.end() ? 0.0 : value->second;
}

EntryBound bound_of(const MachineConfig& machine, const ToolSet& command) {
  const int value = channels::tool_value_named(command.key.view());
  if (value == 0) return {};
  return EntryBounds(machine).of_tool(static_cast<channels::ToolValue>(value));
}

EntryBound bound_of(const MachineConfig& machine, const OffsetSet& command) {
  const std::string name = axis_of_place(command);
  const auto axis = std::ranges::find(machine.axes, name, &channels::AxisConfig::name);
  if (axis == machine.axes.end() && name != rotation) return {};
  return EntryBounds(machine).of_offset(static_cast<int>(axis - machine.axes.begin()));
}

// Values that a tool has a length, or an offset a place, by.
bool is_place(const ToolSet& command) {
  return command.key.view().starts_with("length");
}
bool is_place(const OffsetSet& /*command*/) {
  return true;
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.12g", value);
  return text.data();
}

template <class Command>
std::string doubt_of_value(const MachineConfig& machine, const Command& command) {
  const EntryBound bound = bound_of(machine, command);
  if (bound.holds(command.value)) return {};
  return name_of_entry(command) + ": " + std::string(reason_against(bound, command.value).view());
}

template <class Command>
std::string doubt_of_change(const MachineConfig& machine, const TablesConfig& now,
                            const Command& command) {
  const double before = value_at(now, command).value_or(0.0);
  const double most = machine.entry_limits.change_max;
  if (!is_place(command) || before == 0.0 || std::abs(command.value - before) <= most) return {};
  const std::string unit(bound_of(machine, command).unit);
  return name_of_entry(command) + ": from " + number_text(before) + " to " +
         number_text(command.value) + " " + unit + " is a change of more than " +
         number_text(most) + " " + unit + " (change_max)";
}

template <class Command>
constexpr bool is_entry = std::is_same_v<Command, ToolSet> || std::is_same_v<Command, OffsetSet>;

// `of` of a ToolSet or OffsetSet, else nothing, false or empty.
auto visit_entry(const channels::OperatorCommand& command, const auto& of) {
  using Result = decltype(of(ToolSet{}));
  return std::visit(
      [&](const auto& one) -> Result {
        if constexpr (is_entry<std::decay_t<decltype(one)>>) return of(one);
        return {};
      },
      command);
}

}  // namespace

std::optional<double> value_at(const TablesConfig& tables, const channels::OperatorCommand& place) {
  return visit_entry(place, [&](const auto& one) { return value_at(tables, one); });
}

std::string doubt_of_value(const MachineConfig& machine, const channels::OperatorCommand& command) {
  return visit_entry(command, [&](const auto& one) { return doubt_of_value(machine, one); });
}

std::string doubt_of_entry(const MachineConfig& machine, const TablesConfig& now,
                           const channels::OperatorCommand& command) {
  return visit_entry(command, [&](const auto& one) {
    std::string doubt = doubt_of_value(machine, one);
    return doubt.empty() ? doubt_of_change(machine, now, one) : doubt;
  });
}

std::optional<protocol::Failure> obstacle_to_entry(RunningMachine& machine,
                                                   const channels::OperatorEvent& event,
                                                   const nlohmann::json& parameters) {
  const bool is_of_tables = visit_entry(event.command, [](const auto&) { return true; });
  if (!is_of_tables || parameters.value("confirmed", 0) != 0) return std::nullopt;
  std::string doubt = doubt_of_entry(machine.file().machine, machine.tables(), event.command);
  if (doubt.empty()) return std::nullopt;
  return protocol::Failure{
      protocol::FailureKind::refused, "E6095", std::move(doubt), event.channel, {}};
}

}  // namespace stanok::daemon
