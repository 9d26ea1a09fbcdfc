// Cartesian scheme: see cartesian.h for the formulas.
#include "kinematics/cartesian.h"

#include "kinematics/scheme.h"

namespace stanok::kinematics {

LinearAxes linear_axes(const SchemeConfig& config) {
  const auto taking_part = [&](int axis) { return takes_part(config, axis) ? axis : -1; };
  return LinearAxes({taking_part(config.linear[0]), taking_part(config.linear[1]),
                     taking_part(config.linear[2])});
}

AxisShift::AxisShift(const SchemeConfig& config) : linear_(linear_axes(config)) {
  for (const AxisIndex axis : config.axes) zero_[axis] = config.zero[axis];
}

void AxisShift::forward(const ToolVector& tool, const AxisVector<double>& axes_M,
                        AxisVector<double>& point_B) const RT_SAFE {
  point_B = axes_M;
  linear_.set<double>(linear_.of(point_B) + tool.nose_to_tip_mm, point_B);
  for (std::size_t axis = 0; axis < axes_max; ++axis) point_B[axis] -= zero_[axis];
}

Cartesian::Cartesian(const SchemeConfig& config) : FormulaScheme(config), shift_(config) {}

void Cartesian::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                        AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(tool, axes_M, point_B);
}

std::string Cartesian::defect(const SchemeConfig& config) {
  return config.axes.empty() ? "no axis takes part" : "";
}

}  // namespace stanok::kinematics
