// EntryBounds: between which limits a value of the tables is plausible, by [entry_limits] of the
// machine file and the travel of its axes. Programs are refused what lies beyond, people are asked.
//
// A work offset is where the zero of the workpiece lies, in readings of the axis: the tip of a tool
// gets to it, so that it is at most one tool length beyond the travel. Lengths mm, angles deg. Made
// when the machine starts; any thread.
#pragma once

#include <limits>
#include <string_view>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/texts.h"
#include "channels/contract/tool_value.h"

namespace stanok::channels {

struct EntryBound {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  // What sets either of them, for messages.
  std::string_view least_by;
  std::string_view most_by;
  std::string_view unit = "mm";

  // Never of what is no number.
  [[nodiscard]] bool holds(double value) const RT_SAFE { return value >= least && value <= most; }
};

class EntryBounds {
 public:
  explicit EntryBounds(const MachineConfig& machine);

  // Infinite for orientations and angles, whose ranges are fixed.
  [[nodiscard]] EntryBound of_tool(ToolValue value) const RT_SAFE;
  // `axis` counts among all axes of the machine; any other number: the rotation of the offset.
  [[nodiscard]] EntryBound of_offset(int axis) const RT_SAFE;
  // Of a change of wear or of a work offset while a program runs.
  [[nodiscard]] EntryBound of_change_in_run(std::string_view unit) const RT_SAFE;

 private:
  EntryLimits limits_;
  NumberedList<EntryBound> axes_;
};

// "99999 mm is more than 500 mm (tool_length_max)", for a value that the bound does not hold.
[[nodiscard]] FixedText<160> reason_against(const EntryBound& bound, double value) RT_SAFE;

}  // namespace stanok::channels
