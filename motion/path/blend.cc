// Fitting a blend to the tolerance (motion/path/blend.h).
//
// t and k are tangent and curvature (q', q'') of the two segments at the corner; a blend of reach L
// deviates by about bow * L * |t_out - t_in| + sag * L^2 * |k_out - k_in|, for lines exactly so.
#include "motion/path/blend.h"

#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"
#include "motion/path/point_algebra.h"

namespace stanok::motion {
namespace {

constexpr double bow = (1.0 + 5.0 * blend_beta + 10.0 * blend_gamma) / 32.0;
constexpr double sag = 1.0 / 64.0;

// Part of the tolerance that blends use. The rest covers the chord between two setpoints, which
// passes an inside corner a little farther off than the curve does, and the deviation_samples of
// deviation_share.
constexpr double blend_tolerance_used = 0.97;

constexpr double reach_min = 1e-5;       // mm: below, the stored points no longer resolve the curve
constexpr double arc_angle_max = 0.5;    // rad of an arc that a blend may replace
constexpr double curve_part_max = 0.25;  // of a programmed curve
constexpr int deviation_samples = 16;
constexpr int foot_steps = 3;
constexpr int fit_attempts = 16;

Tolerance used_of(const Tolerance& tolerance) {
  return {blend_tolerance_used * tolerance.mm, blend_tolerance_used * tolerance.deg};
}

// How fast the deviation grows with the reach, relative to the tolerance: linear with the kink,
// quadratic with the step of curvature.
struct Growth {
  double kink = 0.0;
  double step = 0.0;

  [[nodiscard]] double share(double reach) const { return (kink + step * reach) * reach; }
  // The reach at which the share is 1.
  [[nodiscard]] double reach() const { return 2.0 / (kink + std::sqrt(kink * kink + 4.0 * step)); }
  // d log(share) / d log(reach), between 1 and 2.
  [[nodiscard]] double exponent(double reach) const {
    const double linear = kink;
    const double quadratic = step * reach;
    return linear + quadratic > 0.0 ? (linear + 2.0 * quadratic) / (linear + quadratic) : 1.0;
  }
};

// A follower's kink: against the course at equal parameters, and against the course at the foot of
// the point on either leg, which lies cos(theta) of the other leg's way along it.
double follower_kink(double incoming, double outgoing, double cosine) {
  return std::max({std::abs(outgoing - incoming), std::abs(outgoing - incoming * cosine),
                   std::abs(incoming - outgoing * cosine)});
}

Growth growth(const Contact& in, const Contact& out, const PathMetric& metric,
              const Tolerance& tolerance, const MotionConfig& config) {
  const Point kink = difference(out.tangent, in.tangent);
  const Point step = difference(out.curvature, in.curvature);
  Growth grown{bow * geometry_norm(config, kink) / tolerance.mm,
               sag * geometry_norm(config, step) / tolerance.mm};
  const bool over_geometry = std::ranges::any_of(
      config.geometry, [&](int axis) { return axis >= 0 && metric.counts(axis); });
  const double cosine = over_geometry ? metric_product(metric, in.tangent, out.tangent) : 1.0;
  for (int k = 0; k < config.axis_count; ++k) {
    if (is_geometry_axis(config, k)) continue;
    const double allowed = axis_tolerance(config, k, tolerance);
    const double bent = follower_kink(in.tangent[k], out.tangent[k], cosine);
    grown.kink = std::max(grown.kink, bow * bent / allowed);
    grown.step = std::max(grown.step, sag * std::abs(step[k]) / allowed);
  }
  return grown;
}

Contact contact_at(const Segment& segment, double s) {
  JetPoint point_s;
  evaluate(segment, s, point_s);
  return contact(point_s);
}

// How much of a segment a blend may replace.
double replaceable(const Segment& segment) {
  if (segment.geometry.kind == SegmentKind::line) return segment.length;
  if (segment.geometry.kind == SegmentKind::quintic) return curve_part_max * segment.length;
  return segment.length * std::min(1.0, arc_angle_max / std::abs(segment.geometry.sweep));
}

Blend blend_of_reach(const Segment& incoming, const Segment& outgoing, double reach) {
  return {blend_curve(incoming.geometry.metric, contact_at(incoming, incoming.length - reach),
                      contact_at(outgoing, reach), reach),
          reach};
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

double deviation_share(const Blend& blend, const Segment& incoming, const Segment& outgoing,
                       const Tolerance& tolerance, const MotionConfig& config) {
  const Segment curve = segment_of(blend.shape);
  double share = corner_share(curve, incoming.geometry.end, 0.5, tolerance, config);
  for (int i = 1; i < deviation_samples; ++i) {
    const double u = static_cast<double>(i) / deviation_samples;
    const Point point = position_at(curve, u);
    share = std::max(
        share, to_nearer_leg(incoming, outgoing, blend.reach, u, point, tolerance, config).share);
  }
  return share;
}

double corner_reach(const Segment& incoming, const Segment& outgoing, const Tolerance& tolerance,
                    const MotionConfig& config) {
  const Growth grown = growth(contact_at(incoming, incoming.length), contact_at(outgoing, 0.0),
                              incoming.geometry.metric, tolerance, config);
  return bow / grown.kink;
}

std::optional<Blend> fit_blend(const Segment& incoming, const Segment& outgoing, double reach_max,
                               const Tolerance& tolerance, const MotionConfig& config) {
  const Tolerance used = used_of(tolerance);
  const Growth grown = growth(contact_at(incoming, incoming.length), contact_at(outgoing, 0.0),
                              incoming.geometry.metric, used, config);
  double reach = std::min({reach_max, grown.reach(), replaceable(incoming), replaceable(outgoing)});
  const bool between_lines =
      incoming.geometry.kind == SegmentKind::line && outgoing.geometry.kind == SegmentKind::line;
  for (int i = 0; i < fit_attempts && reach >= reach_min; ++i) {
    const Blend blend = blend_of_reach(incoming, outgoing, reach);
    if (between_lines) return blend;
    const double share = deviation_share(blend, incoming, outgoing, used, config);
    if (share <= 1.0) return blend;
    reach *= std::clamp(0.98 * std::pow(share, -1.0 / grown.exponent(reach)), 0.1, 0.9);
  }
  return std::nullopt;
}

}  // namespace stanok::motion
