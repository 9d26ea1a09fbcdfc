// Lathe scheme: see lathe.h for the formulas.
#include "kinematics/lathe.h"

#include <algorithm>

#include "kinematics/scheme.h"

namespace stanok::kinematics {

Vector3<double> reading_per_mm(const LatheGeometry& geometry) {
  const double across = geometry.turret == Turret::front ? -1.0 : 1.0;
  const double counted = geometry.x_reading == XReading::diameter ? 2.0 : 1.0;
  return {across * counted, across, 1.0};
}

std::vector<SchemeKey> LatheGeometry::keys() {
  return {{"x_reading", Choice(x_reading, {"radius", "diameter"}),
           "what the machine's X axis counts; points are always in radius"},
          {"turret", Choice(turret, {"rear", "front"}),
           "side of the workpiece; in front, X and Y of the machine point against the "
           "workpiece's"}};
}

LatheShift::LatheShift(const SchemeConfig& config, const LatheGeometry& geometry)
    : shift_(config), linear_(linear_axes(config)), factor_(reading_per_mm(geometry)) {}

ToolVector LatheShift::as_read(const ToolVector& tool) const RT_SAFE {
  return {factor_.cwiseProduct(tool.nose_to_tip_mm)};
}

void LatheShift::forward(const ToolVector& tool, const AxisVector<double>& axes_M,
                         AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(as_read(tool), axes_M, point_B);
  linear_.set<double>(linear_.of(point_B).cwiseQuotient(factor_), point_B);
}

Lathe::Lathe(const SchemeConfig& config)
    : FormulaScheme(config), shift_(config, std::get<Geometry>(config.geometry)) {}

void Lathe::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                    AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(tool, axes_M, point_B);
}

std::string Lathe::defect(const SchemeConfig& config) {
  const bool has_both = kinematics::takes_part(config, config.linear[0]) &&
                        kinematics::takes_part(config, config.linear[2]);
  return has_both ? "" : "X and Z must take part";
}

TurnedWorkpiece turned_workpiece(const SchemeConfig& active, int rotary_axis) {
  const auto* lathe = std::get_if<LatheGeometry>(&active.geometry);
  return {.base_type = active.type,
          .lathe = lathe == nullptr ? LatheGeometry() : *lathe,
          .rotary_axis = rotary_axis};
}

std::string turned_workpiece_defect(const SchemeConfig& config, const TurnedWorkpiece& workpiece,
                                    std::size_t radial) {
  if (workpiece.base_type != Cartesian::type_name && workpiece.base_type != Lathe::type_name) {
    return "it rides on a cartesian or lathe scheme, not on '" + workpiece.base_type + "'";
  }
  if (!takes_part(config, config.linear[radial]))
    return std::string(1, "XYZ"[radial]) + " must take part";
  if (!takes_part(config, workpiece.rotary_axis)) return "the rotary axis must take part";
  if (std::ranges::find(config.linear, workpiece.rotary_axis) != config.linear.end()) {
    return "the rotary axis must be none of X, Y, Z";
  }
  return "";
}

}  // namespace stanok::kinematics
