#include "channels/contract/entry_bounds.h"

#include <algorithm>
#include <cmath>

namespace stanok::channels {
namespace {

using Text = FixedText<160>;

constexpr double whole_turn_deg = 360.0;
constexpr double offset_without_travel_mm = 10'000.0;

EntryBound bound_above(double most, std::string_view by) RT_SAFE {
  EntryBound bound;
  bound.most = most;
  bound.most_by = by;
  return bound;
}

EntryBound bound_between(double least, std::string_view least_by, double most,
                         std::string_view most_by) RT_SAFE {
  EntryBound bound = bound_above(most, most_by);
  bound.least = least;
  bound.least_by = least_by;
  return bound;
}

EntryBound by_magnitude(double most, std::string_view by) RT_SAFE {
  return bound_between(-most, by, most, by);
}

// Infinite where the axis has no end.
double farthest_travel(const AxisConfig& axis) {
  return std::max(std::abs(axis.limits.position_min), std::abs(axis.limits.position_max));
}

EntryBound bound_of_angle(double most_deg) RT_SAFE {
  EntryBound bound = by_magnitude(most_deg, "a whole turn");
  bound.unit = "deg";
  return bound;
}

EntryBound bound_of_offset(const AxisConfig& axis, const EntryLimits& limits) {
  const double travel = farthest_travel(axis);
  if (axis.rotary)
    return bound_of_angle(std::isfinite(travel) ? std::max(travel, whole_turn_deg)
                                                : whole_turn_deg);
  if (limits.offset_max_mm > 0.0) return by_magnitude(limits.offset_max_mm, "offset_max");
  return by_magnitude(
      std::isfinite(travel) ? travel + limits.tool_length_max_mm : offset_without_travel_mm,
      "offset_max");
}

// Three decimals, without zeros at their end.
void append_number(Text& text, double value) RT_SAFE {
  constexpr double largest = 1e12;
  if (std::isnan(value)) {
    text.append("no number");
    return;
  }
  if (value < 0.0) text.append("-");
  const double magnitude = std::abs(value);
  if (magnitude > largest) {
    text.append("more than 1e12");
    return;
  }
  const auto thousandths = std::lround(magnitude * 1000.0);
  text.append(thousandths / 1000);
  long rest = thousandths % 1000;
  if (rest == 0) return;
  text.append(".");
  for (long digit = 100; rest > 0; digit /= 10) {
    text.append(rest / digit);
    rest %= digit;
  }
}

}  // namespace

EntryBounds::EntryBounds(const MachineConfig& machine) : limits_(machine.entry_limits) {
  for (const AxisConfig& axis : machine.axes) axes_.push_back(bound_of_offset(axis, limits_));
}

EntryBound EntryBounds::of_tool(ToolValue value) const RT_SAFE {
  switch (value) {
    case ToolValue::length:
      return bound_between(limits_.tool_length_min_mm, "tool_length_min",
                           limits_.tool_length_max_mm, "tool_length_max");
    case ToolValue::length_x:
    case ToolValue::length_y:
      return by_magnitude(limits_.tool_length_max_mm, "tool_length_max");
    case ToolValue::overhang:
      return bound_between(0.0, "an overhang", limits_.tool_length_max_mm, "tool_length_max");
    case ToolValue::radius:
      return bound_above(limits_.tool_radius_max_mm, "tool_radius_max");
    case ToolValue::wear_length:
    case ToolValue::wear_length_x:
    case ToolValue::wear_radius:
      return by_magnitude(limits_.wear_max_mm, "wear_max");
    case ToolValue::orientation:
    case ToolValue::angle_front:
    case ToolValue::angle_back:
      break;
  }
  return {};
}

EntryBound EntryBounds::of_offset(int axis) const RT_SAFE {
  if (axis >= 0 && axis < static_cast<int>(axes_.size())) return axes_[axis];
  return bound_of_angle(whole_turn_deg);
}

EntryBound EntryBounds::of_change_in_run(std::string_view unit) const RT_SAFE {
  EntryBound bound = by_magnitude(limits_.change_in_run_max, "change_in_run_max");
  bound.unit = unit;
  return bound;
}

FixedText<160> reason_against(const EntryBound& bound, double value) RT_SAFE {
  const bool is_less = value < bound.least;
  Text text;
  append_number(text, value);
  text.append(" ").append(bound.unit).append(is_less ? " is less than " : " is more than ");
  append_number(text, is_less ? bound.least : bound.most);
  text.append(" ").append(bound.unit).append(" (");
  return text.append(is_less ? bound.least_by : bound.most_by).append(")");
}

}  // namespace stanok::channels
