// Independent references of the schemes, in long double: what the machine axes of a point must be.
//
// Written from the drawings of the machines, not from the formulas of the schemes: homogeneous 4x4
// chains for tool and workpiece, rotations by Rodrigues' formula about a unit vector, complex
// numbers for the polar face. The tool chain moves from the machine frame through the linear axes,
// the head and the tool; the workpiece chain through the tables.
#pragma once

#include <array>
#include <cmath>
#include <complex>

#include "kinematics/scheme.h"

namespace stanok::kinematics::reference {

using Real = long double;
using Vector = std::array<Real, 3>;
using Matrix = std::array<std::array<Real, 4>, 4>;
using Axes = std::array<Real, axes_max>;

inline const Real pi = std::acos(-1.0L);

inline Matrix identity() {
  Matrix m{};
  for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1.0L;
  return m;
}

inline Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) product[i][j] += a[i][k] * b[k][j];
  return product;
}

inline Matrix moved(const Vector& by) {
  Matrix m = identity();
  for (std::size_t i = 0; i < 3; ++i) m[i][3] = by[i];
  return m;
}

// Rodrigues: R = I + sin K + (1 - cos) K^2 about the unit vector k.
inline Matrix turned(const Vector& k, Real degrees) {
  const Real angle = degrees * pi / 180.0L;
  const Matrix cross{{{0, -k[2], k[1], 0}, {k[2], 0, -k[0], 0}, {-k[1], k[0], 0, 0}, {0, 0, 0, 0}}};
  const Matrix cross_squared = cross * cross;
  Matrix rotation = identity();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      rotation[i][j] +=
          std::sin(angle) * cross[i][j] + (1.0L - std::cos(angle)) * cross_squared[i][j];
  return rotation;
}

inline Vector position(const Matrix& m) {
  return {m[0][3], m[1][3], m[2][3]};
}

inline Vector exact(const Vector3<double>& v) {
  return {v.x(), v.y(), v.z()};
}

inline std::size_t slot(int axis) {
  return static_cast<std::size_t>(axis);
}

// Zero and tool vector alone: every type in PointMode::axes, and the cartesian scheme in both.
inline Axes shifted(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  Axes axes = point;
  for (const int axis : config.axes) axes[slot(axis)] += config.zero[slot(axis)];
  for (std::size_t k = 0; k < 3; ++k) {
    if (config.linear[k] >= 0) axes[slot(config.linear[k])] -= nose_to_tip[k];
  }
  return axes;
}

// The linear axes lead the end of the tool chain to the end of the workpiece chain.
inline Axes led(const SchemeConfig& config, const Axes& point, const Matrix& tool_chain,
                const Matrix& workpiece_chain) {
  Axes axes = shifted(config, point, {});
  for (std::size_t k = 0; k < 3; ++k) {
    axes[slot(config.linear[k])] = position(workpiece_chain)[k] - position(tool_chain)[k];
  }
  return axes;
}

inline Matrix point_in_base(const SchemeConfig& config, const Axes& point) {
  return moved({point[slot(config.linear[0])], point[slot(config.linear[1])],
                point[slot(config.linear[2])]});
}

inline Axes head_table(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  const auto& geometry = std::get<HeadTable::Geometry>(config.geometry);
  const Matrix tool = turned(exact(geometry.head_vector), point[slot(geometry.head_axis)]) *
                      moved(exact(geometry.pivot_to_spindle)) * moved(nose_to_tip);
  const Matrix workpiece = moved(exact(geometry.table_centre)) *
                           turned(exact(geometry.table_vector), point[slot(geometry.table_axis)]) *
                           point_in_base(config, point);
  return led(config, point, tool, workpiece);
}

inline Axes head_head(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  const auto& geometry = std::get<HeadHead::Geometry>(config.geometry);
  const Matrix tool = turned(exact(geometry.outer_vector), point[slot(geometry.outer_axis)]) *
                      moved(exact(geometry.pivot_to_pivot)) *
                      turned(exact(geometry.inner_vector), point[slot(geometry.inner_axis)]) *
                      moved(exact(geometry.pivot_to_spindle)) * moved(nose_to_tip);
  // The base: where the nose stands when the axes read `zero` and the head is upright.
  Vector zero{};
  for (std::size_t k = 0; k < 3; ++k) zero[k] = config.zero[slot(config.linear[k])];
  const Matrix base =
      moved(zero) * moved(exact(geometry.pivot_to_pivot)) * moved(exact(geometry.pivot_to_spindle));
  return led(config, point, tool, base * point_in_base(config, point));
}

inline Axes table_table(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  const auto& geometry = std::get<TableTable::Geometry>(config.geometry);
  const Matrix workpiece = moved(exact(geometry.table_centre)) *
                           turned(exact(geometry.outer_vector), point[slot(geometry.outer_axis)]) *
                           moved(exact(geometry.centre_to_centre)) *
                           turned(exact(geometry.inner_vector), point[slot(geometry.inner_axis)]) *
                           point_in_base(config, point);
  return led(config, point, moved(nose_to_tip), workpiece);
}

// The turret's slides against the workpiece: X and Y mirrored by a half turn about Z when the
// turret stands in front; the scale of X counts twice the way in diameter.
inline Axes lathe(const SchemeConfig& config, const LatheGeometry& geometry, const Axes& point,
                  const Vector& nose_to_tip) {
  Axes slides = shifted(config, point, {});
  const Matrix facing = turned({0, 0, 1}, geometry.turret == Turret::front ? 180 : 0);
  Vector tip{};
  for (std::size_t k = 0; k < 3; ++k) {
    tip[k] = config.linear[k] < 0 ? 0 : point[slot(config.linear[k])] - nose_to_tip[k];
  }
  const Vector slide = position(facing * moved(tip));
  for (std::size_t k = 0; k < 3; ++k) {
    if (config.linear[k] < 0) continue;
    const Real scale = k == 0 && geometry.x_reading == XReading::diameter ? 2 : 1;
    slides[slot(config.linear[k])] = scale * slide[k] + config.zero[slot(config.linear[k])];
  }
  return slides;
}

inline Axes lathe(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  return lathe(config, std::get<Lathe::Geometry>(config.geometry), point, nose_to_tip);
}

// The tool stands on the X axis of the machine, at +r or beyond the centre at -r; the workpiece has
// to be turned so that the point comes under it: point = radius * e^(i angle).
inline Axes polar_face(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  const auto& geometry = std::get<PolarFace::Geometry>(config.geometry);
  const std::complex<Real> p(point[slot(config.linear[0])], point[slot(geometry.rotary_axis)]);
  const Real radius = geometry.negative_side ? -std::abs(p) : std::abs(p);
  Axes turned_point = point;
  turned_point[slot(config.linear[0])] = radius;
  turned_point[slot(geometry.rotary_axis)] = std::arg(p / radius) * 180 / pi;
  return lathe(config, geometry.lathe, turned_point, nose_to_tip);
}

// One turn for every circumference.
inline Axes cylinder(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  const auto& geometry = std::get<Cylinder::Geometry>(config.geometry);
  Axes rolled = point;
  rolled[slot(geometry.rotary_axis)] *= 360 / (2 * pi * geometry.radius_mm);
  return lathe(config, geometry.lathe, rolled, nose_to_tip);
}

}  // namespace stanok::kinematics::reference
