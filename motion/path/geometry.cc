// Lines, arcs and quintics by the chain rule through u(s) (motion/path/geometry.h).
//
// P is the point as a function of the parameter u, P1..P3 its derivatives by u, and u(s) a jet of
// the path length: u' = 1/|P1|, and further by differentiating |P1|^2
// (docs/developer/motion.md#path).
#include "motion/path/geometry.h"

#include <algorithm>
#include <cmath>

#include "motion/path/arc_length.h"

namespace stanok::motion {
namespace {

using kinematics::Jet;

// The point as a function of u.
struct ParametricPoint {
  Point P{};
  Point P1{};
  Point P2{};
  Point P3{};
};

void line_at(const Geometry& g, double u, ParametricPoint& p) RT_SAFE {
  for (std::size_t k = 0; k < axes_max; ++k) {
    p.P1[k] = g.end[k] - g.start[k];
    p.P[k] = g.start[k] + p.P1[k] * u;
  }
}

void arc_at(const Geometry& g, double u, ParametricPoint& p) RT_SAFE {
  line_at(g, u, p);
  const double angle = g.start_angle + g.sweep * u;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double w = g.sweep;
  const double r = g.radius + g.radius_change * u;
  const double r1 = g.radius_change;
  const int x = g.plane[0];
  const int y = g.plane[1];
  p.P[x] = g.centre[0] + r * cosine;
  p.P[y] = g.centre[1] + r * sine;
  p.P1[x] = r1 * cosine - r * w * sine;
  p.P1[y] = r1 * sine + r * w * cosine;
  p.P2[x] = -w * (2.0 * r1 * sine + r * w * cosine);
  p.P2[y] = w * (2.0 * r1 * cosine - r * w * sine);
  p.P3[x] = w * w * (r * w * sine - 3.0 * r1 * cosine);
  p.P3[y] = -w * w * (r * w * cosine + 3.0 * r1 * sine);
}

void quintic_at(const Geometry& g, double u, ParametricPoint& p) RT_SAFE {
  for (int k = 0; k < g.metric.axis_count; ++k) {
    const auto& c = g.coefficients[k];
    p.P[k] = ((((c[5] * u + c[4]) * u + c[3]) * u + c[2]) * u + c[1]) * u + c[0];
    p.P1[k] = (((5.0 * c[5] * u + 4.0 * c[4]) * u + 3.0 * c[3]) * u + 2.0 * c[2]) * u + c[1];
    p.P2[k] = ((20.0 * c[5] * u + 12.0 * c[4]) * u + 6.0 * c[3]) * u + 2.0 * c[2];
    p.P3[k] = (60.0 * c[5] * u + 24.0 * c[4]) * u + 6.0 * c[3];
  }
  for (int k = g.metric.axis_count; k < axes_max; ++k) {
    p.P[k] = g.start[k];
  }
}

// u(s) from g = |P1|^2: u' = g^(-1/2), u'' = -g1 / (2 g^2), u''' = u' (g1^2/g - g2/2) / g^2, with
// g1 and g2 the derivatives of g by u.
Jet parameter_by_length(const PathMetric& metric, const ParametricPoint& p, double u) RT_SAFE {
  double g = 0.0;
  double g1 = 0.0;
  double g2 = 0.0;
  for (int k = 0; k < metric.axis_count; ++k) {
    if (!metric.counts(k)) continue;
    g += p.P1[k] * p.P1[k];
    g1 += 2.0 * p.P1[k] * p.P2[k];
    g2 += 2.0 * (p.P2[k] * p.P2[k] + p.P1[k] * p.P3[k]);
  }
  const double u1 = 1.0 / std::sqrt(g);
  const double inverse_squared = 1.0 / (g * g);
  return {u, u1, -0.5 * g1 * inverse_squared, u1 * inverse_squared * (g1 * g1 / g - 0.5 * g2)};
}

void line_by_length(const Segment& segment, double u, JetPoint& point_s) RT_SAFE {
  const Geometry& g = segment.geometry;
  for (std::size_t k = 0; k < axes_max; ++k) {
    const double way = g.end[k] - g.start[k];
    point_s[k] = {g.start[k] + way * u, way / segment.length, 0.0, 0.0};
  }
}

}  // namespace

void evaluate_at_parameter(const Segment& segment, double u, JetPoint& point_s) RT_SAFE {
  const Geometry& g = segment.geometry;
  if (g.kind == SegmentKind::line) {
    line_by_length(segment, u, point_s);
  } else {
    ParametricPoint p;
    g.kind == SegmentKind::arc ? arc_at(g, u, p) : quintic_at(g, u, p);
    const Jet u_s = g.kind == SegmentKind::even ? Jet{u, 1.0 / segment.length, 0.0, 0.0}
                                                : parameter_by_length(g.metric, p, u);
    for (std::size_t k = 0; k < axes_max; ++k) {
      point_s[k] = compose(u_s, p.P[k], p.P1[k], p.P2[k], p.P3[k]);
    }
  }
  if (u > 0.0 && u < 1.0) return;
  const Point& stored = u <= 0.0 ? g.start : g.end;
  for (std::size_t k = 0; k < axes_max; ++k) point_s[k].value = stored[k];
}

void evaluate(const Segment& segment, double s, JetPoint& point_s) RT_SAFE {
  evaluate_at_parameter(segment, parameter_at(segment.geometry, s, segment.length), point_s);
}

void along_time(const JetPoint& point_s, double v, double a, double j, int axis_count,
                JetPoint& point_t) RT_SAFE {
  const Jet s_t{0.0, v, a, j};
  for (int k = 0; k < axis_count; ++k) {
    const Jet& q = point_s[k];
    point_t[k] = compose(s_t, q.value, q.first, q.second, q.third);
  }
}

}  // namespace stanok::motion
