// RS274 parameters that the interpreter knows itself: #<_line>, #<_x>, #5420, #5220, ...
//
// They are read-only. Meanings and numbers are those of LinuxCNC ("G-code overview", numbered and
// predefined named parameters); lengths stand in programmed units, X in diameters where these are
// programmed, codes in tenths as in #<_motion_mode> = 382.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "lang/block/active_block.h"

namespace stanok::lang {

// The order of axes in blocks of numbered parameters.
inline constexpr std::string_view parameter_axes = "XYZABCUVW";

// What predefined parameters are read from.
struct ParameterView {
  const BlockSurroundings& around;
  std::uint32_t line = 0;
  int call_level = 0;           // 0: main program
  double value = 0.0;           // of the last O-subprogram
  bool value_returned = false;  // it had one
};

struct PredefinedParameter {
  std::string_view name;                           // folded, with its _
  double (*read)(const ParameterView&) = nullptr;  // NaN: not known now
};

[[nodiscard]] std::span<const PredefinedParameter> predefined_parameters();
// The row of #<name> by its folded name, or nullptr.
[[nodiscard]] const PredefinedParameter* find_predefined_parameter(std::string_view folded_name);

// What an absolute word would have to say for the axis to stay where it is: programmed units,
// diameters, before scaling and mirror.
[[nodiscard]] double programmed_position(const BlockSurroundings& around, AxisIndex axis);
// A coordinate in mm or deg as an axis word would have it, and back.
[[nodiscard]] double as_programmed(const BlockSurroundings& around, AxisIndex axis, double value);
// Likewise of a place in M, which counts diameters on some machines.
[[nodiscard]] double machine_as_programmed(const BlockSurroundings& around, AxisIndex axis,
                                           double value_M);
[[nodiscard]] double from_programmed(const BlockSurroundings& around, AxisIndex axis, double value);

// The value of #number if it shows the state of the machine; nothing for the numbers that programs
// set.
[[nodiscard]] std::optional<double> machine_parameter(int number, const ParameterView& view);

}  // namespace stanok::lang
