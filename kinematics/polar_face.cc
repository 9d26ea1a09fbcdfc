// Polar face scheme: see polar_face.h for the formulas.
#include "kinematics/polar_face.h"

#include <cmath>

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

constexpr double pole_radius_mm = 1e-9;  // the accuracy asked of forward(inverse(point))

}  // namespace

Polar<double> polar(double x, double y) RT_SAFE {
  const double r = std::hypot(x, y);
  if (r <= pole_radius_mm) return {};
  return {r, std::atan2(y, x)};
}

// Velocity, acceleration and jerk of a plane motion p(t) along the radial direction u and the
// transverse direction n, solved for the derivatives of radius r and angle a:
//   u.p'   = r'                           n.p'   = r a'
//   u.p''  = r'' - r a'^2                 n.p''  = r a'' + 2 r' a'
//   u.p''' = r''' - 3 r' a'^2 - 3 r a' a''
//   n.p''' = r a''' + 3 r'' a' + 3 r' a'' - r a'^3
Polar<Jet> polar(const Jet& x, const Jet& y) RT_SAFE {
  const auto [r, angle] = polar(x.value, y.value);
  if (r <= pole_radius_mm) return {};
  const double ux = x.value / r;
  const double uy = y.value / r;
  const auto radial = [&](double px, double py) RT_SAFE { return ux * px + uy * py; };
  const auto transverse = [&](double px, double py) RT_SAFE { return ux * py - uy * px; };
  const double r1 = radial(x.first, y.first);
  const double a1 = transverse(x.first, y.first) / r;
  const double r2 = radial(x.second, y.second) + r * a1 * a1;
  const double a2 = (transverse(x.second, y.second) - 2.0 * r1 * a1) / r;
  const double r3 = radial(x.third, y.third) + 3.0 * a1 * (r1 * a1 + r * a2);
  const double a3 = (transverse(x.third, y.third) - 3.0 * (r2 * a1 + r1 * a2)) / r + a1 * a1 * a1;
  return {{r, r1, r2, r3}, {angle, a1, a2, a3}};
}

PolarFace::PolarFace(const SchemeConfig& config)
    : PolarFace(config, std::get<Geometry>(config.geometry)) {}

PolarFace::PolarFace(const SchemeConfig& config, const Geometry& geometry)
    : FormulaScheme(config),
      shift_(config, geometry.lathe),
      x_(config.linear[geometry.radial]),
      rotary_(geometry.rotary_axis),
      side_(geometry.negative_side ? -1.0 : 1.0) {}

// On the negative side the radius is negative and the angle that of the opposite point: the product
// is the same.
void PolarFace::forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
                        AxisVector<double>& point_B) const RT_SAFE {
  shift_.forward(tool, axes_M, point_B);
  const double radius = point_B[x_];
  const auto [sine, cosine] = sine_cosine(rad_per_deg * point_B[rotary_]);
  point_B[x_] = radius * cosine;
  point_B[rotary_] = radius * sine;
}

double PolarFace::distance_to_singularity(const AxisVector<double>& point_B) const RT_SAFE {
  return std::hypot(point_B[x_], point_B[rotary_]);
}

std::string PolarFace::defect(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  return turned_workpiece_defect(config, geometry, geometry.radial);
}

SchemeConfig face_scheme(const SchemeConfig& active, int rotary_axis, FaceSide side,
                         std::size_t radial) {
  SchemeConfig config = active;
  config.type = PolarFace::type_name;
  config.geometry = PolarFace::Geometry{turned_workpiece(active, rotary_axis),
                                        side == FaceSide::negative, radial};
  return config;
}

}  // namespace stanok::kinematics
