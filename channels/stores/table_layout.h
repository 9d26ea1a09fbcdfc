// TableLayout: which entries the tables of a machine have, and in which cell each value lies.
//
// Cells are numbered from 0: first the work offsets, row by row, then the tools. A tool without a
// row in the tables has a place of its own, which an operator's value fills; that it is filled is a
// cell, too. Fixed when the machine starts; any thread.
#pragma once

#include <string>
#include <string_view>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/tool_row.h"
#include "channels/contract/tool_value.h"

namespace stanok::channels {

// The table name of a work offset number: 1 = "G54" ... 7 = "G59.1", 10 = "G54.1 P1".
[[nodiscard]] std::string work_offset_name(int number);
// The number of work_offset_name; 0: there is no such offset.
[[nodiscard]] int work_offset_number(std::string_view name) RT_SAFE;

class TableLayout {
 public:
  static constexpr int work_offsets_max = 9 + 300;  // G54..G59.3 and G54.1 P1..P300

  struct ToolPlace {
    ToolEdge fixed;           // number, edge, name, kind, shape
    ToolRow row;              // of the same
    bool is_default = false;  // no row of the tables
  };

  explicit TableLayout(const MachineConfig& machine);

  [[nodiscard]] int cells() const RT_SAFE { return first_tool_cell_ + tool_count() * tool_cells; }

  // `axis` counts among all axes of the machine, or is lang::rotation_of_offset; -1: there is no
  // such entry.
  [[nodiscard]] int offset_cell(int number, int axis) const RT_SAFE;
  // `axis` of the call above by the name of the machine's axis, "R": the rotation; -1: none.
  [[nodiscard]] int column(std::string_view axis) const RT_SAFE;
  [[nodiscard]] int column_count() const RT_SAFE { return static_cast<int>(columns_.size()); }
  // "X" or "R" of an axis that has an offset.
  [[nodiscard]] std::string_view column_name(int axis) const RT_SAFE;

  [[nodiscard]] int tool_count() const RT_SAFE { return static_cast<int>(tools_.size()); }
  [[nodiscard]] const ToolPlace& tool(int place) const RT_SAFE { return tools_[place]; }
  // The place of a tool, whether it is there or not; -1: there is none.
  [[nodiscard]] int tool_place(int number, int edge) const RT_SAFE;
  // Of a ToolValue, from 1.
  [[nodiscard]] int tool_cell(int place, int value) const RT_SAFE {
    return first_tool_cell_ + place * tool_cells + value;
  }
  // 1: the tool is there; 0: its place is free.
  [[nodiscard]] int presence_cell(int place) const RT_SAFE { return tool_cell(place, 0); }

 private:
  static constexpr int tool_cells = 1 + tool_values;

  NumberedList<std::string> columns_;  // of the offsets: the axes, and R, the rotation
  NumberedList<ToolPlace> tools_;      // ascending by number and edge
  int first_tool_cell_ = 0;
};

// In the order of ToolValue.
[[nodiscard]] NumberedArray<double, tool_values> values_of(const ToolEdge& tool);

// What `value(k)` gives for ToolValue k, from 1, into the fields of a ToolEdge or ToolRow.
template <class Tool, class Value>
void take_values(const Value& value, Tool& tool) RT_SAFE {
  const auto of = [&value](ToolValue named) RT_SAFE { return value(static_cast<int>(named)); };
  tool.length = of(ToolValue::length);
  tool.length_y = of(ToolValue::length_y);
  tool.length_x = of(ToolValue::length_x);
  tool.radius = of(ToolValue::radius);
  tool.wear_length = of(ToolValue::wear_length);
  tool.wear_radius = of(ToolValue::wear_radius);
  tool.overhang = of(ToolValue::overhang);
  tool.orientation = static_cast<int>(of(ToolValue::orientation));
  tool.angle_front = of(ToolValue::angle_front);
  tool.angle_back = of(ToolValue::angle_back);
  tool.wear_length_x = of(ToolValue::wear_length_x);
}

}  // namespace stanok::channels
