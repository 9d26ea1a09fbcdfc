// Construction of lines, arcs, blends and parts (motion/path/shape.h).
#include "motion/path/shape.h"

#include <cmath>
#include <numbers>

#include "motion/path/arc_length.h"
#include "motion/path/blend.h"
#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

Shape with_length(const Geometry& geometry) {
  return {geometry, arc_length(geometry)};
}

Geometry geometry_between(const PathMetric& metric, const Point& start, const Point& end) {
  Geometry geometry;
  geometry.metric = metric;
  geometry.start = start;
  geometry.end = end;
  return geometry;
}

struct Polar {
  double radius;
  double angle;
};

Polar polar(const Point& point, const std::array<int, 2>& plane,
            const std::array<double, 2>& centre) {
  const double x = point[plane[0]] - centre[0];
  const double y = point[plane[1]] - centre[1];
  return {std::hypot(x, y), std::atan2(y, x)};
}

// The polynomial over a part of its parameter, which becomes 0 to 1 again.
std::array<double, 6> part_of_polynomial(const std::array<double, 6>& c, double from, double to) {
  std::array<double, 6> shifted = c;
  for (std::size_t m = 0; m < 6; ++m) {
    for (std::size_t k = 5; k > m; --k) shifted[k - 1] += from * shifted[k];
  }
  double power = 1.0;
  for (double& coefficient : shifted) {
    coefficient *= power;
    power *= to - from;
  }
  return shifted;
}

}  // namespace

std::array<double, 6> quintic_between(double p0, double v0, double a0, double p1, double v1,
                                      double a1) {
  const double way = p1 - p0 - v0 - 0.5 * a0;
  const double speed = v1 - v0 - a0;
  const double change = a1 - a0;
  return {p0,
          v0,
          0.5 * a0,
          10.0 * way - 4.0 * speed + 0.5 * change,
          -15.0 * way + 7.0 * speed - change,
          6.0 * way - 3.0 * speed + 0.5 * change};
}

Shape line(const PathMetric& metric, const Point& start, const Point& end) {
  return with_length(geometry_between(metric, start, end));
}

Shape arc(const PathMetric& metric, const Point& start, const PathBlock& block) {
  Geometry geometry = geometry_between(metric, start, block.end);
  geometry.kind = SegmentKind::arc;
  geometry.plane = block.plane;
  geometry.centre = block.centre;
  const Polar from = polar(start, block.plane, block.centre);
  const Polar to = polar(block.end, block.plane, block.centre);
  geometry.radius = from.radius;
  geometry.radius_change = to.radius - from.radius;
  geometry.start_angle = from.angle;
  const double rounding =
      std::remainder(to.angle - from.angle - block.sweep_rad, 2.0 * std::numbers::pi);
  geometry.sweep = block.sweep_rad + rounding;
  return with_length(geometry);
}

Shape curve(const PathMetric& metric, const Point& start, const PathBlock& block) {
  Geometry geometry = geometry_between(metric, start, block.end);
  geometry.kind = SegmentKind::quintic;
  for (std::size_t k = 0; k < axes_max; ++k) {
    geometry.coefficients[k] = {start[k], block.end[k] - start[k], 0.0, 0.0, 0.0, 0.0};
  }
  for (std::size_t c = 0; c < 2; ++c) geometry.coefficients[block.plane[c]] = block.curve[c];
  measure(geometry);
  return with_length(geometry);
}

Contact contact(const JetPoint& point_s) {
  Contact at;
  for (std::size_t k = 0; k < axes_max; ++k) {
    at.position[k] = point_s[k].value;
    at.tangent[k] = point_s[k].first;
    at.curvature[k] = point_s[k].second;
  }
  return at;
}

Contact contact_at(const Segment& segment, double s) {
  JetPoint point_s;
  evaluate(segment, s, point_s);
  return contact(point_s);
}

Shape blend_curve(const PathMetric& metric, const Contact& from, const Contact& to, double reach) {
  Geometry geometry = geometry_between(metric, from.position, to.position);
  geometry.kind = SegmentKind::quintic;
  // Control points P1 = P0 + (1 - beta) L t and P2 = P0 + (1 - gamma) L t + h^2/20 q''.
  const double h = 5.0 * (1.0 - blend_beta) * reach;
  const double g = 20.0 * (2.0 * blend_beta - 1.0 - blend_gamma) * reach;
  for (int k = 0; k < metric.axis_count; ++k) {
    geometry.coefficients[k] = quintic_between(
        from.position[k], h * from.tangent[k], h * h * from.curvature[k] + g * from.tangent[k],
        to.position[k], h * to.tangent[k], h * h * to.curvature[k] - g * to.tangent[k]);
  }
  measure(geometry);
  return with_length(geometry);
}

Shape part(const Segment& whole, double s_start, const Point& start, double s_end,
           const Point& end) {
  Geometry geometry = whole.geometry;
  geometry.start = start;
  geometry.end = end;
  if (geometry.kind == SegmentKind::arc) {
    const double from = parameter_at(whole.geometry, s_start, whole.length);
    const double to = parameter_at(whole.geometry, s_end, whole.length);
    geometry.radius += whole.geometry.radius_change * from;
    geometry.radius_change *= to - from;
    geometry.start_angle += whole.geometry.sweep * from;
    geometry.sweep *= to - from;
  }
  if (geometry.kind == SegmentKind::quintic) {
    const double from = parameter_at(whole.geometry, s_start, whole.length);
    const double to = parameter_at(whole.geometry, s_end, whole.length);
    for (auto& coefficients : geometry.coefficients)
      coefficients = part_of_polynomial(coefficients, from, to);
    measure(geometry);
  }
  return with_length(geometry);
}

}  // namespace stanok::motion
