// Where a point that lies on a rotary table is when the table has turned.
//
// Both places are points in B as PointMode::axes counts them, which does not turn with the table:
// what a work offset says. mm and deg.
#pragma once

#include <optional>

#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

// The point `from_B`, which the table carries from the angles of `from_B` to those of `to_B`;
// nothing: no rotary axis of the scheme turns the workpiece. All but X, Y and Z stay as in
// `from_B`.
[[nodiscard]] std::optional<AxisVector<double>> carried_point(const Scheme& scheme,
                                                              const AxisVector<double>& from_B,
                                                              const AxisVector<double>& to_B);

}  // namespace stanok::kinematics
