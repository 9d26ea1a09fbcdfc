// Cylinder scheme: see cylinder.h for the formulas.
#include "kinematics/cylinder.h"

#include <cmath>

#include "kinematics/angle_units.h"

namespace stanok::kinematics {

Cylinder::Cylinder(const SchemeConfig& config)
    : FormulaScheme(config),
      shift_(config),
      rotary_(static_cast<std::size_t>(config.rotary_axis)),
      mm_per_deg_(rad_per_deg * config.radius_mm) {}

void Cylinder::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                       AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(tool, axes_M, point_B);
  point_B[rotary_] *= mm_per_deg_;
}

std::string cylinder_defect(const SchemeConfig& config) {
  if (!(config.radius_mm > 0.0 && std::isfinite(config.radius_mm))) {
    return "the radius of the cylinder must be above 0";
  }
  return turned_workpiece_defect(config);
}

SchemeConfig cylinder_scheme(const SchemeConfig& active, int rotary_axis, double radius_mm) {
  SchemeConfig config = active;
  config.type = "cylinder";
  config.base_type = active.type;
  config.rotary_axis = rotary_axis;
  config.radius_mm = radius_mm;
  return config;
}

}  // namespace stanok::kinematics
