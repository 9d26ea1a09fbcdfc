#include "simulation/machine_geometry.h"

#include <cmath>
#include <numbers>

#include "kinematics/linear_axes.h"

namespace stanok::simulation {
namespace {

using kinematics::PointMode;
using kinematics::Scheme;

kinematics::ToolVector tool_vector(const Vector& v) {
  return {v};
}

Vector linear_of(const Scheme& scheme, const Axes& axes) {
  return kinematics::LinearAxes(scheme.config().linear).of(axes);
}

void set_linear(const Scheme& scheme, const Vector& point, Axes& axes) {
  kinematics::LinearAxes(scheme.config().linear).set(point, axes);
}

// The rotary axes of the head stand where those of `other` stand.
void set_head(const Scheme& scheme, const Axes& other, Axes& axes) {
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    if ((scheme.head_axes() >> axis & 1U) != 0) axes[axis] = other[axis];
  }
}

Vector tip_in_base(const Scheme& scheme, const Axes& axes_M, const Vector& nose_to_tip) {
  Axes point_B{};
  scheme.forward(PointMode::tip, tool_vector(nose_to_tip), axes_M, point_B);
  return linear_of(scheme, point_B);
}

// With the heads upright and no tool, X, Y and Z read this where the tip is.
Vector upright_point(const Scheme& scheme, const Axes& axes_M, const Vector& nose_to_tip) {
  Axes point_B{};
  scheme.forward(PointMode::tip, tool_vector(nose_to_tip), axes_M, point_B);
  set_head(scheme, Axes{}, point_B);
  Axes upright_M{};
  scheme.inverse(PointMode::tip, {}, point_B, upright_M);
  return linear_of(scheme, upright_M);
}

Vector base_of_upright(const Scheme& scheme, const Axes& axes_M, const Vector& point) {
  Axes upright_M = axes_M;
  set_head(scheme, scheme.config().zero, upright_M);
  set_linear(scheme, point, upright_M);
  return tip_in_base(scheme, upright_M, Vector::Zero());
}

}  // namespace

Vector ToolMount::axis() const {
  int longest = 2;
  for (int k = 0; k < 2; ++k) {
    if (std::abs(nose_to_tip[k]) > std::abs(nose_to_tip[longest])) longest = k;
  }
  const double sign = nose_to_tip[longest] > 0.0 ? -1.0 : 1.0;
  return sign * Vector::Unit(longest);
}

ToolPlace MachineGeometry::place_in(int home, int active, const Axes& axes_M,
                                    const ToolMount& mount) const {
  const auto point = [&](const Vector& nose_to_point) {
    if (home == active) return tip_in_base(scheme(home), axes_M, nose_to_point);
    return base_of_upright(scheme(home), axes_M,
                           upright_point(scheme(active), axes_M, nose_to_point));
  };
  ToolPlace place;
  place.tip = point(mount.nose_to_tip);
  place.axis = (point(mount.nose_to_tip + mount.axis()) - place.tip).normalized();
  return place;
}

// A positive angle turns the tool round the workpiece, counter-clockwise against Z (polar_face.h).
ToolPlace MachineGeometry::turned_with_workpiece(int home, const Axes& axes_M,
                                                 const ToolPlace& place_B) const {
  const AxisIndex axis = geometry_.turning_axis;
  if (!axis.exists()) return place_B;
  const double angle = (axes_M[axis] - scheme(home).config().zero[axis]) * std::numbers::pi / 180.0;
  const Eigen::AngleAxisd turn(angle, Vector::UnitZ());
  return {turn * place_B.tip, turn * place_B.axis};
}

Pose MachineGeometry::machine_in(int home, const Axes& axes_M) const {
  const Vector origin = base_of_upright(scheme(home), axes_M, Vector::Zero());
  Pose pose = Pose::Identity();
  for (int k = 0; k < 3; ++k) {
    const Vector along = base_of_upright(scheme(home), axes_M, Vector::Unit(k)) - origin;
    pose.linear().col(k) =
        along.norm() > 0.0 ? Vector(along.normalized()) : Vector(Vector::Unit(k));
  }
  pose.translation() = origin;
  return pose;
}

Pose MachineGeometry::linear_axes_in(int home, const Axes& axes_M) const {
  const Scheme& of_home = scheme(home);
  if (!of_home.is_affine(PointMode::axes)) return Pose::Identity();
  return machine_in(home, axes_M) * Eigen::Translation3d(linear_of(of_home, of_home.config().zero));
}

}  // namespace stanok::simulation
