// Cylinder scheme: see cylinder.h for the formulas.
#include "kinematics/cylinder.h"

#include <cmath>

#include "kinematics/angle_units.h"
#include "kinematics/scheme.h"

namespace stanok::kinematics {

Cylinder::Cylinder(const SchemeConfig& config)
    : Cylinder(config, std::get<Geometry>(config.geometry)) {}

Cylinder::Cylinder(const SchemeConfig& config, const Geometry& geometry)
    : FormulaScheme(config),
      shift_(config, geometry.lathe),
      rotary_(geometry.rotary_axis),
      mm_per_deg_(rad_per_deg * geometry.radius_mm) {}

void Cylinder::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                       AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(tool, axes_M, point_B);
  point_B[rotary_] *= mm_per_deg_;
}

std::string Cylinder::defect(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  if (!(geometry.radius_mm > 0.0 && std::isfinite(geometry.radius_mm))) {
    return "the radius of the cylinder must be above 0";
  }
  return turned_workpiece_defect(config, geometry);
}

SchemeConfig cylinder_scheme(const SchemeConfig& active, int rotary_axis, double radius_mm) {
  SchemeConfig config = active;
  config.type = Cylinder::type_name;
  config.geometry = Cylinder::Geometry{turned_workpiece(active, rotary_axis), radius_mm};
  return config;
}

}  // namespace stanok::kinematics
