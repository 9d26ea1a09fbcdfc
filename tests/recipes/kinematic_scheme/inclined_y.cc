// Inclined Y: see inclined_y.h for the formulas.
#include "kinematics/inclined_y.h"

#include <cmath>

#include "kinematics/angle_units.h"
#include "kinematics/scheme.h"

namespace stanok::kinematics {

std::vector<SchemeKey> InclinedY::Geometry::keys() {
  return {{"angle", Number{angle_deg, "deg", -60.0, 60.0}, "of the Y slide, from Y towards X"}};
}

InclinedY::InclinedY(const SchemeConfig& config)
    : FormulaScheme(config),
      shift_(config),
      linear_(linear_axes(config)),
      sine_(std::sin(rad_per_deg * std::get<Geometry>(config.geometry).angle_deg)),
      cosine_(std::cos(rad_per_deg * std::get<Geometry>(config.geometry).angle_deg)) {}

void InclinedY::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                        AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward({}, axes_M, point_B);
  point_B[linear_.x] += sine_ * point_B[linear_.y];
  point_B[linear_.y] *= cosine_;
  linear_.subtract(-tool.nose_to_tip_mm, point_B);
}

std::string InclinedY::defect(const SchemeConfig& config) {
  const LinearAxes linear = linear_axes(config);
  return linear.x.exists() && linear.y.exists() ? "" : "X and Y must take part";
}

}  // namespace stanok::kinematics
