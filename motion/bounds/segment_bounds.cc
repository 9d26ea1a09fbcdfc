// Derivative bounds of a segment (motion/bounds/segment_bounds.h) and the speeds they allow.
#include "motion/bounds/segment_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/numbered.h"
#include "motion/path/geometry.h"
#include "motion/path/point_algebra.h"
#include "motion/path/sampling.h"

namespace stanok::motion {
namespace {

using kinematics::Jet;

// Largest |q'|, |q''|, |q'''| of one axis.
struct LargestDerivatives {
  double first = 0.0;
  double second = 0.0;
  double third = 0.0;
};
using AxisDerivatives = kinematics::AxisVector<LargestDerivatives>;

constexpr int sampling_intervals_max = 8192;
// Sampling is refined until what may lie between samples is below this share of the bound.
constexpr double margin_share_max = 0.05;
constexpr double margin_seen_min = 1e-4;  // of a limit; what takes less need not be resolved
constexpr double override_max = 2.0;

bool moves(const Segment& segment, int axis) {
  const Geometry& g = segment.geometry;
  const bool is_polynomial = g.kind == SegmentKind::quintic || g.kind == SegmentKind::even;
  if (!is_polynomial) return g.start[axis] != g.end[axis];
  return std::any_of(g.coefficients[axis].begin() + 1, g.coefficients[axis].end(),
                     [](double c) { return c != 0.0; });
}

SegmentBounds bounds_of(const AxisDerivatives& q, const Segment& segment,
                        const MotionConfig& config) {
  SegmentBounds bounds;
  for (int k = 0; k < config.axis_count; ++k) {
    const AxisLimits& limit = config.axes[k];
    const double velocity_max = segment.rapid ? limit.rapid_speed_max() : limit.velocity_max;
    bounds.velocity = std::max(bounds.velocity, q[k].first / velocity_max);
    bounds.tangent = std::max(bounds.tangent, q[k].first / limit.acceleration_max);
    bounds.thrust = std::max(bounds.thrust, q[k].first / limit.jerk_max);
    bounds.curvature = std::max(bounds.curvature, q[k].second / limit.acceleration_max);
    bounds.bend = std::max(bounds.bend, q[k].second / limit.jerk_max);
    bounds.aberrancy = std::max(bounds.aberrancy, q[k].third / limit.jerk_max);
  }
  return bounds;
}

// The one limit of X, Y and Z, if there is one: the transform may turn them, and nothing else
// moves.
std::optional<AxisLimits> common_limits(const Segment& segment, const MotionConfig& config) {
  if (!is_affine(segment)) return std::nullopt;
  std::optional<AxisLimits> common;
  for (int k = 0; k < config.axis_count; ++k) {
    const AxisLimits& limits = config.axes[k];
    if (!is_geometry_axis(config, k)) {
      if (moves(segment, k)) return std::nullopt;
      continue;
    }
    const bool differs = common && (limits.acceleration_max != common->acceleration_max ||
                                    limits.jerk_max != common->jerk_max);
    // On the side of a cylinder mm are deg of an axis.
    if (differs || !limits.linear) return std::nullopt;
    common = limits;
  }
  return common;
}

// `turn`: largest Euclidean |q''|.
SegmentBounds::Euclidean euclidean_bounds(double turn, const AxisLimits& limits) {
  return {.holds = true,
          .tangent = 1.0 / limits.acceleration_max,
          .thrust = 1.0 / limits.jerk_max,
          .curvature = turn / limits.acceleration_max,
          .bend = turn / limits.jerk_max};
}

AxisDerivatives of_affine_line(const Segment& segment) {
  JetPoint point_s;
  JetPoint axes_M;
  evaluate_at_parameter(segment, 0.0, point_s);
  to_machine(segment, point_s, axes_M);
  AxisDerivatives q;
  for (std::size_t k = 0; k < axes_max; ++k) q[k].first = std::abs(axes_M[k].first);
  return q;
}

// Largest |constant + a cos(phi) + b sin(phi)| over the angles between `from` and `to`.
double wave_peak(double constant, double a, double b, double from, double to) {
  const auto wave = [=](double angle) {
    return std::abs(constant + a * std::cos(angle) + b * std::sin(angle));
  };
  double peak = std::max(wave(from), wave(to));
  const double lower = std::min(from, to);
  const double upper = std::max(from, to);
  const double crest = std::atan2(b, a);
  const double amplitude = std::hypot(a, b);
  const auto passes = [=](double angle) {
    const double turn = 2.0 * std::numbers::pi;
    return angle + turn * std::ceil((lower - angle) / turn) <= upper;
  };
  if (passes(crest)) peak = std::max(peak, std::abs(constant + amplitude));
  if (passes(crest + std::numbers::pi)) peak = std::max(peak, std::abs(constant - amplitude));
  return peak;
}

// How much the change of radius may add to derivatives of the circle, as a factor: each derivative
// differs by a few times r' / (r sweep), and the angular speed by the ratio of the radii.
double spiral_factor(const Geometry& g) {
  const double radius_end = g.radius + g.radius_change;
  const double least = std::min(g.radius, radius_end);
  const double slope = std::abs(g.radius_change / (least * g.sweep));
  const double ratio = std::max(g.radius, radius_end) / least;
  return (1.0 + 8.0 * slope) * ratio * ratio * ratio;
}

// Above this the arc is a spiral rather than a circle with rounded ends, and is sampled.
constexpr double spiral_factor_max = 1.01;

AxisDerivatives of_affine_arc(const Segment& segment, double factor) {
  const Geometry& g = segment.geometry;
  // An affine map takes each derivative of a jet by itself, so one jet carries three directions:
  // the linear part per s, and the two unit vectors of the plane.
  JetPoint directions_W{};
  for (std::size_t k = 0; k < axes_max; ++k) {
    directions_W[k] = Jet(g.start[k], (g.end[k] - g.start[k]) / segment.length, 0.0, 0.0);
  }
  directions_W[g.plane[0]] = Jet(g.start[0], 0.0, 1.0, 0.0);
  directions_W[g.plane[1]] = Jet(g.start[0], 0.0, 0.0, 1.0);
  JetPoint directions_M;
  to_machine(segment, directions_W, directions_M);

  const double to = g.start_angle + g.sweep;
  const double turn_rate = g.sweep / segment.length;  // rad per s
  const double along = std::max(g.radius, g.radius + g.radius_change) * turn_rate;
  AxisDerivatives q;
  for (std::size_t k = 0; k < axes_max; ++k) {
    const Jet& d = directions_M[k];
    const double a = d.second * along;
    const double b = d.third * along;
    q[k].first = factor * wave_peak(d.first, b, -a, g.start_angle, to);
    q[k].second = factor * std::abs(turn_rate) * wave_peak(0.0, a, b, g.start_angle, to);
    q[k].third = factor * turn_rate * turn_rate * wave_peak(0.0, b, -a, g.start_angle, to);
  }
  return q;
}

// |q''| of an arc: r w^2 for w = angle per length, along a helix too.
double arc_turn(const Segment& segment) {
  const Geometry& g = segment.geometry;
  const double turn_rate = g.sweep / segment.length;
  return std::max(g.radius, g.radius + g.radius_change) * turn_rate * turn_rate;
}

// The largest magnitude among three neighbouring samples, with and without what may lie between.
struct Peak {
  double sampled = 0.0;
  double bound = 0.0;

  void take(double before, double here, double after) {
    const double largest = std::max({std::abs(before), std::abs(here), std::abs(after)});
    sampled = std::max(sampled, largest);
    bound = std::max(bound, largest + between_samples * std::abs(after - 2.0 * here + before));
  }
};

struct AxisPeaks {
  Peak first;
  Peak second;
  Peak third;
};
struct Peaks : kinematics::AxisVector<AxisPeaks> {
  Peak turn;  // Euclidean |q''| of X, Y, Z in W
};

double turn_of(const JetPoint& point_s, const MotionConfig& config) {
  double squared = 0.0;
  for (const int axis : config.geometry) {
    if (axis < 0) continue;
    const double second = point_s[axis].second;
    squared += second * second;
  }
  return std::sqrt(squared);
}

Peaks sampled_peaks(const Segment& segment, int intervals, const MotionConfig& config) {
  Peaks peaks;
  NumberedArray<JetPoint, 3> window;
  NumberedArray<double, 3> turns{};
  for (int i = 0; i <= intervals; ++i) {
    JetPoint point_s;
    evaluate_at_parameter(segment, static_cast<double>(i) / intervals, point_s);
    to_machine(segment, point_s, window[i % 3]);
    turns[i % 3] = turn_of(point_s, config);
    if (i < 2) continue;
    const JetPoint& before = window[(i - 2) % 3];
    const JetPoint& here = window[(i - 1) % 3];
    const JetPoint& after = window[i % 3];
    peaks.turn.take(turns[(i - 2) % 3], turns[(i - 1) % 3], turns[i % 3]);
    for (int k = 0; k < config.axis_count; ++k) {
      peaks[k].first.take(before[k].first, here[k].first, after[k].first);
      peaks[k].second.take(before[k].second, here[k].second, after[k].second);
      peaks[k].third.take(before[k].third, here[k].third, after[k].third);
    }
  }
  return peaks;
}

AxisDerivatives taken(const Peaks& peaks, double Peak::* value) {
  AxisDerivatives q;
  for (std::size_t k = 0; k < axes_max; ++k) {
    q[k] = {peaks[k].first.*value, peaks[k].second.*value, peaks[k].third.*value};
  }
  return q;
}

// Whether the margins matter little where they decide: in the bounds, not in every axis. A margin
// that takes no more than `margin_seen_min` of a limit at the highest speed `v` of the segment is
// nothing, whatever its share: on a straight path curvature is rounding, and never settles.
bool is_resolved(const SegmentBounds& sampled, const SegmentBounds& bounds, double v) {
  const auto close = [](double peak, double bound, double weight) {
    return bound - peak <= std::max(margin_share_max * bound, margin_seen_min / weight);
  };
  constexpr double always = std::numeric_limits<double>::infinity();
  return close(sampled.velocity, bounds.velocity, always) &&
         close(sampled.tangent, bounds.tangent, always) &&
         close(sampled.thrust, bounds.thrust, always) &&
         close(sampled.curvature, bounds.curvature, v * v) &&
         close(sampled.bend, bounds.bend, 3.0 * v / bounds.tangent) &&
         close(sampled.aberrancy, bounds.aberrancy, v * v * v);
}

SegmentBounds sampled_bounds(const Segment& segment, const MotionConfig& config) {
  int intervals = sampling_intervals(segment, config);
  for (;;) {
    const Peaks peaks = sampled_peaks(segment, intervals, config);
    SegmentBounds bounds = bounds_of(taken(peaks, &Peak::bound), segment, config);
    const SegmentBounds sampled = bounds_of(taken(peaks, &Peak::sampled), segment, config);
    const double v = std::min(override_max * segment.feed_per_s, 1.0 / bounds.velocity);
    if (intervals >= sampling_intervals_max || is_resolved(sampled, bounds, v)) {
      if (const auto limits = common_limits(segment, config))
        bounds.euclidean = euclidean_bounds(peaks.turn.bound, *limits);
      return bounds;
    }
    intervals *= 2;
  }
}

}  // namespace

SegmentBounds segment_bounds(const Segment& segment, const MotionConfig& config) {
  if (is_affine(segment) && segment.geometry.kind == SegmentKind::line) {
    return bounds_of(of_affine_line(segment), segment, config);
  }
  if (is_affine(segment) && segment.geometry.kind == SegmentKind::arc) {
    const double factor = spiral_factor(segment.geometry);
    if (factor < spiral_factor_max) {
      SegmentBounds bounds = bounds_of(of_affine_arc(segment, factor), segment, config);
      if (const auto limits = common_limits(segment, config))
        bounds.euclidean = euclidean_bounds(factor * arc_turn(segment), *limits);
      return bounds;
    }
  }
  return sampled_bounds(segment, config);
}

}  // namespace stanok::motion
