// Schemes on rotary chains: see rotary_scheme.h for the formulas.
// Symbols as there: p workpiece point in B, X linear axes in M, c centre of the table.
#include "kinematics/rotary_scheme.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/scheme.h"

namespace stanok::kinematics {

RotaryScheme::RotaryScheme(const SchemeConfig& config, const Chains& chains)
    : FormulaScheme(config), shift_(config), linear_(config.linear), chains_(chains) {}

void RotaryScheme::forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
                           AxisVector<double>& point_B) const RT_SAFE {
  if (mode == PointMode::axes) {
    shift_.forward(tool, axes_M, point_B);
    return;
  }
  const Vector3<double> X = linear_.of(axes_M);
  shift_.forward(ToolVector{}, axes_M, point_B);  // rotary axes
  const Vector3<double> tip = X + chains_.head.reach(point_B, tool.nose_to_tip_mm);
  linear_.set(chains_.table.reach_back(point_B, tip - chains_.centre), point_B);
}

// The tool stands as the head turns it and the table turns back from it:
//   head, head     R1 R2 z = u           table, table   R1 R2 u = z
//   head, table    Rt^T Rh z = u, whose outer turn is the one of the table backwards
DirectionSolution RotaryScheme::directions(const Vector3<double>& tool_B) const RT_SAFE {
  const Vector3<double> upright{0.0, 0.0, 1.0};
  const auto head = chains_.head.joints();
  const auto table = chains_.table.joints();
  if (head.size() + table.size() != 2) return {};
  if (head.size() == 1) {
    DirectionSolution solution = solve({table[0].vector, head[0].vector, upright, tool_B});
    solution.axes = {head[0].axis, table[0].axis};
    for (DirectionBranch& branch : solution.branches) {
      const double back = -branch.angles_deg[0];
      branch.angles_deg = {branch.angles_deg[1], back <= -180.0 ? 180.0 : back + 0.0};
      std::swap(branch.is_free[0], branch.is_free[1]);
    }
    return solution;
  }
  const auto both = head.empty() ? table : head;
  DirectionSolution solution =
      head.empty()
          ? solve({both[0].vector, both[1].vector, tool_B, upright, TwoTurns::Wanted::from})
          : solve({both[0].vector, both[1].vector, upright, tool_B});
  solution.axes = {both[0].axis, both[1].axis};
  return solution;
}

std::array<Vector3<double>, 3> RotaryScheme::spindle_axes(const AxisVector<double>& point_B) const
    RT_SAFE {
  std::array<Vector3<double>, 3> axes = Scheme::spindle_axes(point_B);
  for (Vector3<double>& axis : axes) {
    axis = chains_.table.direction_back(point_B, chains_.head.direction(point_B, axis));
  }
  return axes;
}

std::string rotary_scheme_defect(const SchemeConfig& config, const RotaryRole& first,
                                 const RotaryRole& second) {
  if (!std::ranges::all_of(config.linear, [&](int axis) { return takes_part(config, axis); })) {
    return "X, Y and Z must take part";
  }
  for (const RotaryRole* role : {&first, &second}) {
    if (!takes_part(config, role->axis)) {
      return "the " + std::string(role->axis_key) + " must take part";
    }
    const Vector3<double>& v = role->vector;
    if (!(std::abs(std::hypot(v.x(), v.y(), v.z()) - 1.0) < 1e-12)) {
      return std::string(role->vector_key) + " must have the length 1";
    }
  }
  if (first.axis == second.axis) {
    return std::string(first.axis_key) + " and " + std::string(second.axis_key) + " must differ";
  }
  return "";
}

AxisVector<double> linear_zero(const SchemeConfig& config, const Vector3<double>& zero) {
  AxisVector<double> axes{};
  LinearAxes(config.linear).set(zero, axes);
  return axes;
}

}  // namespace stanok::kinematics
