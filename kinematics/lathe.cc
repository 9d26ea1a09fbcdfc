// Lathe scheme: see lathe.h for the formulas.
#include "kinematics/lathe.h"

#include <algorithm>

namespace stanok::kinematics {
namespace {

std::array<double, 3> reading_per_mm(const SchemeConfig& config) {
  const double across = config.turret == Turret::front ? -1.0 : 1.0;
  const double counted = config.x_reading == XReading::diameter ? 2.0 : 1.0;
  return {across * counted, across, 1.0};
}

}  // namespace

LatheShift::LatheShift(const SchemeConfig& config)
    : shift_(config), linear_(config.linear), factor_(reading_per_mm(config)) {
  for (int& axis : linear_) {
    if (!takes_part(config, axis)) axis = -1;
  }
}

ToolVector LatheShift::as_read(const ToolVector& tool) const RT_SAFE {
  const auto& [x, y, z] = tool.nose_to_tip_mm;
  return {{factor_[0] * x, factor_[1] * y, factor_[2] * z}};
}

void LatheShift::forward(const ToolVector& tool, const AxisVector<double>& axes_M,
                         AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(as_read(tool), axes_M, point_B);
  for (std::size_t k = 0; k < factor_.size(); ++k) {
    if (linear_[k] >= 0) point_B[static_cast<std::size_t>(linear_[k])] /= factor_[k];
  }
}

Lathe::Lathe(const SchemeConfig& config) : FormulaScheme(config), shift_(config) {}

void Lathe::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                    AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(tool, axes_M, point_B);
}

std::string lathe_defect(const SchemeConfig& config) {
  return takes_part(config, config.linear[0]) && takes_part(config, config.linear[2])
             ? ""
             : "X and Z must take part";
}

std::string turned_workpiece_defect(const SchemeConfig& config) {
  if (config.base_type != "cartesian" && config.base_type != "lathe") {
    return "it rides on a cartesian or lathe scheme, not on '" + config.base_type + "'";
  }
  if (!takes_part(config, config.linear[0])) return "X must take part";
  if (!takes_part(config, config.rotary_axis)) return "the rotary axis must take part";
  if (std::ranges::find(config.linear, config.rotary_axis) != config.linear.end()) {
    return "the rotary axis must be none of X, Y, Z";
  }
  return "";
}

}  // namespace stanok::kinematics
