// The values of a tool that programs read and write, by name and by number from 1.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace stanok::lang {

// In the order of their numbers.
inline constexpr auto tool_value_names = std::to_array<std::string_view>(
    {"length", "length_y", "length_x", "radius", "wear_length", "wear_radius", "overhang",
     "orientation", "angle_front", "angle_back", "wear_length_x"});

// Whether the value is in mm; orientations and angles are not.
[[nodiscard]] constexpr bool is_tool_length(int number) {
  constexpr int lengths = 7;  // the first of them
  return number <= lengths || number == 11;
}
// Whether it is measured along X, where lathes count in diameters.
[[nodiscard]] constexpr bool is_along_x(int number) {
  return number == 3 || number == 11;
}

// 0: there is no such value.
[[nodiscard]] constexpr int tool_value_number(std::string_view folded_name) {
  const auto found = std::find(tool_value_names.begin(), tool_value_names.end(), folded_name);
  return found == tool_value_names.end() ? 0
                                         : static_cast<int>(found - tool_value_names.begin()) + 1;
}

}  // namespace stanok::lang
