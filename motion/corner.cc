// Judging a join by the tangents and curvatures that meet there, and a blend by the time it takes
// (motion/corner.h).
#include "motion/corner.h"

#include <algorithm>
#include <cmath>

#include "motion/geometry.h"
#include "motion/piece_bounds.h"

namespace stanok::motion {
namespace {

// Rounding of programmed coordinates in tangents and curvatures, relative.
constexpr double continuous_within = 1e-9;
// Sharper turns than 165 deg leave a blend no room: stopping is faster.
constexpr double cosine_min = -0.96592582628906831;

// A blend that keeps so much of the feed is taken without asking for the time.
constexpr double feed_kept = 0.8;

bool continues(double before, double after) {
  return std::abs(after - before) <= continuous_within * (1.0 + std::abs(before));
}

// What a block allows on the way from or to the corner.
struct Leg {
  double v;  // top speed, reached from rest within half of the block
  double a;
  double j;
};

Leg leg_of(const Piece& block, const MotionConfig& config) {
  const PieceLimits limits = piece_limits(piece_bounds(block, config), block.feed_per_s);
  const double way = 0.5 * block.length;
  const double reached = std::min(std::cbrt(way * way * limits.j), std::sqrt(2.0 * limits.a * way));
  return {std::min(limits.v, reached), limits.a, limits.j};
}

// Time lost against passing at the leg's top speed by a jerk-limited ramp between it and `v`.
double ramp_loss(const Leg& leg, double v) {
  const double change = std::max(0.0, leg.v - v);
  const double duration = change * leg.j > leg.a * leg.a ? leg.a / leg.j + change / leg.a
                                                         : 2.0 * std::sqrt(change / leg.j);
  return duration * change / (2.0 * leg.v);
}

}  // namespace

Join judge_join(const Piece& incoming, const Piece& outgoing) {
  const PathMetric& metric = incoming.geometry.metric;
  if (metric != outgoing.geometry.metric || incoming.transform != outgoing.transform) {
    return Join::turn;
  }
  JetPoint before;
  JetPoint after;
  evaluate_at_parameter(incoming, 1.0, before);
  evaluate_at_parameter(outgoing, 0.0, after);
  double cosine = 0.0;
  bool smooth = true;
  for (std::size_t k = 0; k < static_cast<std::size_t>(metric.axis_count); ++k) {
    if (metric.counts(k)) cosine += before[k].first * after[k].first;
    smooth = smooth && continues(before[k].first, after[k].first) &&
             continues(before[k].second, after[k].second);
  }
  if (smooth) return Join::smooth;
  return cosine < cosine_min ? Join::turn : Join::corner;
}

bool is_stop_faster(const Piece& incoming, const Piece& blend, const Piece& outgoing,
                    const MotionConfig& config) {
  const double v = piece_limits(blend.bounds, blend.feed_per_s).v;
  if (v >= feed_kept * blend.feed_per_s) return false;
  const Leg before = leg_of(incoming, config);
  const Leg after = leg_of(outgoing, config);
  const double top = std::min(before.v, after.v);
  if (v >= feed_kept * top) return false;
  const double by_blend =
      ramp_loss(before, v) + ramp_loss(after, v) + blend.length * (1.0 / v - 1.0 / top);
  return ramp_loss(before, 0.0) + ramp_loss(after, 0.0) < by_blend;
}

}  // namespace stanok::motion
