#include "channels/contract/tool_value.h"

#include <algorithm>
#include <array>

namespace stanok::channels {
namespace {

// In the order of ToolValue.
constexpr std::array<std::string_view, tool_values> names{
    "length",   "length_y",    "length_x",    "radius",     "wear_length",  "wear_radius",
    "overhang", "orientation", "angle_front", "angle_back", "wear_length_x"};

}  // namespace

int tool_value_named(std::string_view name) RT_SAFE {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
}

std::string_view name_of(ToolValue value) RT_SAFE {
  return names[static_cast<std::size_t>(value) - 1];
}

bool can_be(ToolValue value, double to) RT_SAFE {
  constexpr double length_max = 1e5;  // mm
  constexpr double angle_max = 360.0;
  switch (value) {
    case ToolValue::orientation:
      return to >= 0.0 && to <= 9.0 && to == static_cast<double>(static_cast<int>(to));
    case ToolValue::angle_front:
    case ToolValue::angle_back:
      return to >= -angle_max && to <= angle_max;
    case ToolValue::radius:
      return to >= 0.0 && to <= length_max;
    default:
      return to >= -length_max && to <= length_max;
  }
}

}  // namespace stanok::channels
