#include "channels/stores/table_layout.h"

#include <algorithm>
#include <map>
#include <utility>

#include "lang/contract/command.h"

namespace stanok::channels {
namespace {

constexpr int tools_without_row_max = 99;

// What tools are ordered by.
std::pair<int, int> key_of(const ToolEdge& tool) RT_SAFE {
  return {tool.number, tool.edge};
}

}  // namespace

std::string work_offset_name(int number) {
  if (number <= 6) return "G" + std::to_string(53 + number);
  if (number <= 9) return "G59." + std::to_string(number - 6);
  return "G54.1 P" + std::to_string(number - 9);
}

int work_offset_number(std::string_view name) RT_SAFE {
  constexpr std::array<std::string_view, 9> plain{"G54", "G55",   "G56",   "G57",  "G58",
                                                  "G59", "G59.1", "G59.2", "G59.3"};
  const auto found = std::find(plain.begin(), plain.end(), name);
  if (found != plain.end()) return static_cast<int>(found - plain.begin()) + 1;
  constexpr std::string_view extended = "G54.1 P";
  // starts_with is substr inside, which may throw.
  if (name.size() < extended.size() || !std::equal(extended.begin(), extended.end(), name.begin()))
    return 0;
  int page = 0;
  name.remove_prefix(extended.size());
  if (name.empty() || name.size() > 3) return 0;
  for (const char c : name) {
    if (c < '0' || c > '9') return 0;
    page = 10 * page + (c - '0');
  }
  return page >= 1 && page <= TableLayout::work_offsets_max - 9 ? page + 9 : 0;
}

NumberedArray<double, tool_values> values_of(const ToolEdge& tool) {
  return {{tool.length, tool.length_y, tool.length_x, tool.radius, tool.wear_length,
           tool.wear_radius, tool.overhang, static_cast<double>(tool.orientation), tool.angle_front,
           tool.angle_back, tool.wear_length_x}};
}

TableLayout::TableLayout(const MachineConfig& machine) {
  for (const AxisConfig& axis : machine.axes) columns_.push_back(axis.name);
  columns_.emplace_back("R");
  std::map<std::pair<int, int>, ToolPlace> rows;
  for (int number = 0; number <= tools_without_row_max; ++number) {
    ToolEdge plain;
    plain.number = number;
    rows[{number, 1}] = {plain, row_of(plain), true};
  }
  for (const ToolEdge& tool : machine.tables.tools)
    rows[key_of(tool)] = {tool, row_of(tool), false};
  for (auto& [key, row] : rows) tools_.push_back(std::move(row));
  first_tool_cell_ = work_offsets_max * column_count();
}

int TableLayout::offset_cell(int number, int axis) const RT_SAFE {
  const int rotation = column_count() - 1;
  if (axis == lang::rotation_of_offset) axis = rotation;
  const bool exists = number >= 1 && number <= work_offsets_max && axis >= 0 && axis <= rotation;
  return exists ? (number - 1) * column_count() + axis : -1;
}

int TableLayout::column(std::string_view axis) const RT_SAFE {
  for (int k = 0; k < column_count(); ++k) {
    if (columns_[k] == axis) return k;
  }
  return -1;
}

std::string_view TableLayout::column_name(int axis) const RT_SAFE {
  return columns_[axis == lang::rotation_of_offset ? column_count() - 1 : axis];
}

int TableLayout::tool_place(int number, int edge) const RT_SAFE {
  const auto place = std::lower_bound(tools_.begin(), tools_.end(), std::pair{number, edge},
                                      [](const ToolPlace& tool, const std::pair<int, int>& sought)
                                          RT_SAFE { return key_of(tool.fixed) < sought; });
  if (place == tools_.end() || key_of(place->fixed) != std::pair{number, edge}) return -1;
  return static_cast<int>(place - tools_.begin());
}

}  // namespace stanok::channels
