// ToolValue: the values of a tool that programs and operators write, by the number that
// settable_tool gives them.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/rt_safe.h"

namespace stanok::channels {

enum class ToolValue : std::uint8_t {
  length = 1,
  length_y,
  length_x,
  radius,
  wear_length,
  wear_radius,
  overhang,
  orientation,
  angle_front,
  angle_back,
  wear_length_x,
};
inline constexpr int tool_values = 11;
// "length", "wear_radius"...; 0: there is no such value.
[[nodiscard]] int tool_value_named(std::string_view name) RT_SAFE;
// The name of one of them.
[[nodiscard]] std::string_view name_of(ToolValue value) RT_SAFE;

// Whether a tool can have it at all; what is plausible is another question (entry_bounds.h).
[[nodiscard]] bool can_be(ToolValue value, double to) RT_SAFE;

}  // namespace stanok::channels
