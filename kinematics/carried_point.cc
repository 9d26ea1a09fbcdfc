#include "kinematics/carried_point.h"

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

// Rotary axes of the pair that inclines the tool, of the table or of the head.
AxisVector<bool> axes_of_table(const Scheme& scheme, const DirectionSolution& pair) {
  AxisVector<bool> is_of_table{};
  for (const AxisIndex axis : pair.axes) is_of_table[axis] = (scheme.head_axes() & axis.bit()) == 0;
  return is_of_table;
}

}  // namespace

std::optional<AxisVector<double>> carried_point(const Scheme& scheme,
                                                const AxisVector<double>& from_B,
                                                const AxisVector<double>& to_B) {
  const DirectionSolution pair = scheme.directions({0.0, 0.0, 1.0});
  if (pair.kind == DirectionSolution::Kind::no_rotary_axes) return std::nullopt;
  const AxisVector<bool> is_of_table = axes_of_table(scheme, pair);
  AxisVector<double> at_B = from_B;
  bool has_table = false;
  for (const AxisIndex axis : pair.axes) {
    has_table = has_table || is_of_table[axis];
    if (!is_of_table[axis]) at_B[axis] = 0.0;  // the head points down, whatever it does else
  }
  if (!has_table) return std::nullopt;
  // On the table, as a point that turns with it.
  const ToolVector no_tool;
  AxisVector<double> axes_M{};
  AxisVector<double> on_table{};
  scheme.inverse(PointMode::axes, no_tool, at_B, axes_M);
  scheme.forward(PointMode::tip, no_tool, axes_M, on_table);
  for (const AxisIndex axis : pair.axes) {
    if (is_of_table[axis]) on_table[axis] = to_B[axis];
  }
  scheme.inverse(PointMode::tip, no_tool, on_table, axes_M);
  AxisVector<double> carried{};
  scheme.forward(PointMode::axes, no_tool, axes_M, carried);
  for (const AxisIndex axis : pair.axes) carried[axis] = from_B[axis];
  return carried;
}

}  // namespace stanok::kinematics
