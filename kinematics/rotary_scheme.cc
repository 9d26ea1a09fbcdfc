// Schemes on rotary chains: see rotary_scheme.h for the formulas.
// Symbols as there: p workpiece point in B, X linear axes in M, c centre of the table.
#include "kinematics/rotary_scheme.h"

#include <algorithm>
#include <cmath>

#include "kinematics/scheme.h"

namespace stanok::kinematics {

RotaryScheme::RotaryScheme(const SchemeConfig& config, const Chains& chains)
    : FormulaScheme(config), shift_(config), chains_(chains) {
  for (std::size_t k = 0; k < 3; ++k) linear_[k] = static_cast<std::size_t>(config.linear[k]);
}

void RotaryScheme::forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
                           AxisVector<double>& point_B) const RT_SAFE {
  if (mode == PointMode::axes) {
    shift_.forward(tool, axes_M, point_B);
    return;
  }
  const Vector<double> X{axes_M[linear_[0]], axes_M[linear_[1]], axes_M[linear_[2]]};
  shift_.forward(ToolVector{}, axes_M, point_B);  // rotary axes
  const Vector<double> tip = sum(X, chains_.head.reach(point_B, tool.nose_to_tip_mm));
  const Vector<double>& c = chains_.centre;
  const Vector<double> p =
      chains_.table.reach_back(point_B, {tip[0] - c[0], tip[1] - c[1], tip[2] - c[2]});
  for (std::size_t k = 0; k < 3; ++k) point_B[linear_[k]] = p[k];
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
    const auto& [x, y, z] = role->vector;
    if (!(std::abs(std::hypot(x, y, z) - 1.0) < 1e-12)) {
      return std::string(role->vector_key) + " must have the length 1";
    }
  }
  if (first.axis == second.axis) {
    return std::string(first.axis_key) + " and " + std::string(second.axis_key) + " must differ";
  }
  return "";
}

AxisVector<double> linear_zero(const SchemeConfig& config, const Vector<double>& zero) {
  AxisVector<double> axes{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (config.linear[k] >= 0) axes[static_cast<std::size_t>(config.linear[k])] = zero[k];
  }
  return axes;
}

}  // namespace stanok::kinematics
