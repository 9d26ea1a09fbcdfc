// The direction that the axes of a channel take so that the tool goes straight along X, Y or Z of a
// frame, the rotary axes standing.
#pragma once

#include <cstdint>
#include <optional>

#include "base/axis_index.h"
#include "base/rt_safe.h"
#include "channels/contract/operator_command.h"
#include "kinematics/scheme.h"

namespace stanok::channels {

// `coordinate` 0, 1, 2: X, Y, Z of JogFrame::tool (Z from the tip into the spindle, X and Y as head
// and table have turned them) or JogFrame::plane (as G91 G1 would go in `frame`, that in which the
// axes stand). What each axis goes for 1 mm, mm; 0: it stays. Nothing: the scheme has no straight
// line there, as that of a face that is milled with a rotary axis.
[[nodiscard]] std::optional<AxisArray<double>> jog_direction(JogFrame kind, int coordinate,
                                                             const kinematics::Transform& frame,
                                                             const AxisArray<double>& axes_M)
    RT_SAFE;

}  // namespace stanok::channels
