// Numbered parameters of points: #5061 to #5070 what probing found, #5161 (G28), #5181 (G30), #5191
// (G30 P3) and #5201 (G30 P4) the reference points, nine axes each.
//
// Units and axes as in lang/block/predefined_parameter.h.
#pragma once

#include <optional>

#include "lang/block/active_block.h"

namespace stanok::lang {

// Nothing: another parameter.
[[nodiscard]] std::optional<double> point_parameter(int number, const BlockSurroundings& around);

// True when `number` is a coordinate of a reference point, which now is `value`.
[[nodiscard]] bool set_point_parameter(int number, double value, const BlockSurroundings& around);

}  // namespace stanok::lang
