// How a segment's allowance is shared between its curvature, tangential acceleration and jerk
// (motion/path/geometry.h, docs/developer/motion.md#bounds).
#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

// Shares of acceleration and jerk that curvature may take at the segment's top speed; the rest is
// left for the tangential ones. Speed grows with the square and cube roots of these shares only, so
// that the last 15 % of the allowance buy 8 % and 5 % of speed and would leave no way to change it.
constexpr double curvature_share = 0.85;
constexpr double aberrancy_share = 0.85;
// The share of the jerk left by aberrancy that v a q'' may take; tangential jerk has the rest.
constexpr double bend_share = 0.5;
// Where they add in squares, both have equal parts.
constexpr double bend_share_of_squares = 0.7;

// Speeds and their derivatives stay finite where no axis has a limit.
constexpr double speed_ceiling = 1e6;         // mm/s
constexpr double acceleration_ceiling = 1e9;  // mm/s^2
constexpr double jerk_ceiling = 1e12;         // mm/s^3

// What is left at speed v when the parts along and across the path add as they come.
SegmentLimits rest_of_sums(const SegmentBounds& bounds, double v) RT_SAFE {
  const double acceleration_left = 1.0 - v * v * bounds.curvature;
  const double jerk_left = 1.0 - v * v * v * bounds.aberrancy;
  const double bend = 3.0 * v * bounds.bend;
  const double a = std::min(
      {acceleration_ceiling, acceleration_left / bounds.tangent, bend_share * jerk_left / bend});
  const double j = std::min(jerk_ceiling, (jerk_left - bend * a) / bounds.thrust);
  return {v, a, j};
}

// Does what rest_of_sums does, where both add in squares.
SegmentLimits rest_of_squares(const SegmentBounds& bounds, double v) RT_SAFE {
  const SegmentBounds::Euclidean& e = bounds.euclidean;
  const double across = v * v * e.curvature;
  const double acceleration_left = std::sqrt(std::max(0.0, 1.0 - across * across));
  const double jerk_left = 1.0 - v * v * v * bounds.aberrancy;
  const double bend = 3.0 * v * e.bend;
  const double a = std::min({acceleration_ceiling, acceleration_left / e.tangent,
                             bend_share_of_squares * jerk_left / bend});
  const double bent = bend * a;
  const double j =
      std::min(jerk_ceiling, std::sqrt(jerk_left * jerk_left - bent * bent) / e.thrust);
  return {v, a, j};
}

}  // namespace

SegmentLimits segment_limits(const SegmentBounds& bounds, double feed_per_s) RT_SAFE {
  const double v =
      std::min({feed_per_s, speed_ceiling, 1.0 / std::max(bounds.velocity, bounds.chords),
                std::sqrt(curvature_share / bounds.curvature),
                std::cbrt(aberrancy_share / bounds.aberrancy)});
  const SegmentLimits sums = rest_of_sums(bounds, v);
  if (!bounds.euclidean.holds) return sums;
  const SegmentLimits squares = rest_of_squares(bounds, v);
  return squares.a * squares.j > sums.a * sums.j ? squares : sums;
}

}  // namespace stanok::motion
