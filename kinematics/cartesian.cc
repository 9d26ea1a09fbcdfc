// Cartesian scheme: see cartesian.h for the formulas.
#include "kinematics/cartesian.h"

#include "kinematics/scheme.h"

namespace stanok::kinematics {

AxisShift::AxisShift(const SchemeConfig& config) {
  for (const int axis : config.axes) {
    zero_[static_cast<std::size_t>(axis)] = config.zero[static_cast<std::size_t>(axis)];
  }
  for (std::size_t k = 0; k < linear_.size(); ++k) {
    if (takes_part(config, config.linear[k])) linear_[k] = config.linear[k];
  }
}

void AxisShift::forward(const ToolVector& tool, const AxisVector<double>& axes_M,
                        AxisVector<double>& point_B) const RT_SAFE {
  point_B = axes_M;
  for (std::size_t k = 0; k < linear_.size(); ++k) {
    if (linear_[k] >= 0) point_B[static_cast<std::size_t>(linear_[k])] += tool.nose_to_tip_mm[k];
  }
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
