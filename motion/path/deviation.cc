#include "motion/path/deviation.h"

#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"
#include "motion/path/point_algebra.h"

namespace stanok::motion {
namespace {

constexpr double arc_angle_max = 0.5;    // rad of an arc that a curve may replace
constexpr double curve_part_max = 0.25;  // of a programmed curve
constexpr int samples_of_one = 16;       // of a curve in one part
constexpr int samples_of_part = 8;
constexpr int foot_steps = 3;

// A follower's kink: against the course at equal parameters, and against the course at the foot of
// the point on either leg, which lies cos(theta) of the other leg's way along it.
double follower_kink(double incoming, double outgoing, double cosine) {
  return std::max({std::abs(outgoing - incoming), std::abs(outgoing - incoming * cosine),
                   std::abs(incoming - outgoing * cosine)});
}

// Path length of the point of `segment` nearest to `target`, by Newton's method from `s`.
double foot(const Segment& segment, const Point& target, double s) {
  const PathMetric& metric = segment.geometry.metric;
  for (int i = 0; i < foot_steps; ++i) {
    const Contact at = contact_at(segment, s);
    const Point gap = difference(target, at.position);
    const double bent = 1.0 - metric_product(metric, gap, at.curvature);
    const double step = metric_product(metric, gap, at.tangent) / std::max(bent, 0.1);
    s = std::clamp(s + step, 0.0, segment.length);
  }
  return s;
}

// Distances between two points: Euclidean in the geometry axes, and of the followers.
struct Distance {
  double geometry = 0.0;  // mm
  double share = 0.0;     // of the tolerances, all axes
};

Distance distance(const Point& a, const Point& b, const Tolerance& tolerance,
                  const MotionConfig& config) {
  const Point gap = difference(a, b);
  Distance between;
  between.geometry = geometry_norm(config, gap);
  between.share = between.geometry / tolerance.mm;
  for (int k = 0; k < config.axis_count; ++k) {
    if (is_geometry_axis(config, k)) continue;
    const double allowed = axis_tolerance(config, k, tolerance);
    between.share = std::max(between.share, std::abs(gap[k]) / allowed);
  }
  return between;
}

Point position_at(const Segment& segment, double u) {
  JetPoint point_s;
  evaluate_at_parameter(segment, u, point_s);
  return contact(point_s).position;
}

// Distance of a point of the blend to the nearer of the two legs, at its foot there.
Distance to_nearer_leg(const Segment& incoming, const Segment& outgoing, double reach, double u,
                       const Point& point, const Tolerance& tolerance, const MotionConfig& config) {
  const double before =
      foot(incoming, point, incoming.length - reach * std::max(0.0, 1.0 - 2.0 * u));
  const double after = foot(outgoing, point, reach * std::max(0.0, 2.0 * u - 1.0));
  const Distance in = distance(point, contact_at(incoming, before).position, tolerance, config);
  const Distance out = distance(point, contact_at(outgoing, after).position, tolerance, config);
  return in.geometry < out.geometry ? in : out;
}

// Share of the tolerance at which the curve passes `corner`: Newton's method on the parameter.
double corner_share(const Segment& curve, const Point& corner, double u, const Tolerance& tolerance,
                    const MotionConfig& config) {
  const double s = foot(curve, corner, u * curve.length);
  return distance(contact_at(curve, s).position, corner, tolerance, config).share;
}

Segment segment_of(const Shape& shape) {
  Segment segment;
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  return segment;
}

}  // namespace

Growth growth(const Segment& incoming, const Segment& outgoing, const Bulge& bulge,
              const Tolerance& tolerance, const MotionConfig& config) {
  const Contact in = contact_at(incoming, incoming.length);
  const Contact out = contact_at(outgoing, 0.0);
  const PathMetric& metric = incoming.geometry.metric;
  const Point kink = difference(out.tangent, in.tangent);
  const Point step = difference(out.curvature, in.curvature);
  Growth grown{bulge.kink * geometry_norm(config, kink) / tolerance.mm,
               bulge.step * geometry_norm(config, step) / tolerance.mm};
  const bool over_geometry = std::ranges::any_of(
      config.geometry, [&](int axis) { return axis >= 0 && metric.counts(axis); });
  const double cosine = over_geometry ? metric_product(metric, in.tangent, out.tangent) : 1.0;
  for (int k = 0; k < config.axis_count; ++k) {
    if (is_geometry_axis(config, k)) continue;
    const double allowed = axis_tolerance(config, k, tolerance);
    const double bent = follower_kink(in.tangent[k], out.tangent[k], cosine);
    grown.kink = std::max(grown.kink, bulge.kink * bent / allowed);
    grown.step = std::max(grown.step, bulge.step * std::abs(step[k]) / allowed);
  }
  return grown;
}

double corner_reach(const Segment& incoming, const Segment& outgoing, const Tolerance& tolerance,
                    const MotionConfig& config) {
  return 1.0 / growth(incoming, outgoing, {.kink = 1.0}, tolerance, config).kink;
}

double deviation_share(std::span<const Shape> curve, double reach, const Segment& incoming,
                       const Segment& outgoing, const Tolerance& tolerance,
                       const MotionConfig& config) {
  const bool is_one = curve.size() == 1;
  const Segment middle = segment_of(curve[curve.size() / 2]);
  double share = corner_share(middle, incoming.geometry.end, is_one ? 0.5 : 0.0, tolerance, config);
  const int of_part = is_one ? samples_of_one : samples_of_part;
  const int count = of_part * static_cast<int>(curve.size());
  for (int i = 1; i < count; ++i) {
    const Segment part = segment_of(curve[static_cast<std::size_t>(i / of_part)]);
    const Point point = position_at(part, static_cast<double>(i % of_part) / of_part);
    const double u = static_cast<double>(i) / count;
    share = std::max(share,
                     to_nearer_leg(incoming, outgoing, reach, u, point, tolerance, config).share);
  }
  return share;
}

double replaceable(const Segment& segment) {
  if (segment.geometry.kind == SegmentKind::line) return segment.length;
  if (segment.geometry.kind == SegmentKind::quintic) return curve_part_max * segment.length;
  return segment.length * std::min(1.0, arc_angle_max / std::abs(segment.geometry.sweep));
}

}  // namespace stanok::motion
