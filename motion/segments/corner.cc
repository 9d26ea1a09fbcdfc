// Judging a join by the tangents and curvatures that meet there, and a blend by the time it takes
// (motion/segments/corner.h).
#include "motion/segments/corner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/bounds/segment_bounds.h"
#include "motion/path/geometry.h"
#include "motion/profile/profile.h"

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
struct CornerLeg {
  double way;  // half of the block
  double v;    // top speed, reached from rest within that half
  double a;
  double j;

  [[nodiscard]] RampLimits ramp() const { return {.a = a, .j = j}; }
};

// `jerk_part`: how much of the block's jerk is used.
CornerLeg leg_of(const Segment& block, double jerk_part, const MotionConfig& config) {
  const SegmentLimits limits = segment_limits(segment_bounds(block, config), block.feed_per_s);
  const double j = jerk_part * limits.j;
  const double way = 0.5 * block.length;
  const double reached = std::min(std::cbrt(way * way * j), std::sqrt(2.0 * limits.a * way));
  return {way, std::min(limits.v, reached), limits.a, j};
}

// Time lost against passing at the leg's top speed by a jerk-limited ramp between it and `v`.
double ramp_loss(const CornerLeg& leg, double v) {
  const double change = std::max(0.0, leg.v - v);
  return ramp_duration(leg.v - change, leg.v, leg.ramp()) * change / (2.0 * leg.v);
}

// Time from the middle of the leg to rest at its end, or from rest to there.
double time_with_rest(const CornerLeg& leg) {
  const double ramp = ramp_duration(0.0, leg.v, leg.ramp());
  return ramp + std::max(0.0, leg.way - 0.5 * leg.v * ramp) / leg.v;
}

}  // namespace

Join judge_join(const Segment& incoming, const Segment& outgoing) {
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
  for (int k = 0; k < metric.axis_count; ++k) {
    if (metric.counts(k)) cosine += before[k].first * after[k].first;
    smooth = smooth && continues(before[k].first, after[k].first) &&
             continues(before[k].second, after[k].second);
  }
  if (smooth) return Join::smooth;
  return cosine < cosine_min ? Join::turn : Join::corner;
}

Passage passage_of(std::span<const Segment> curve, double feed) {
  Passage passage{.v = unlimited, .feed = feed};
  for (const Segment& segment : curve) {
    passage.v = std::min(passage.v, segment_limits(segment.bounds, feed).v);
    passage.length += segment.length;
  }
  return passage;
}

bool keeps_speed(const Segment& incoming, const Passage& curve, const Segment& outgoing,
                 const MotionConfig& config) {
  if (curve.v >= feed_kept * curve.feed) return true;
  return curve.v >=
         feed_kept * std::min(leg_of(incoming, 1.0, config).v, leg_of(outgoing, 1.0, config).v);
}

double time_lost(const Segment& incoming, const Passage& curve, const Segment& outgoing,
                 const MotionConfig& config) {
  const CornerLeg before = leg_of(incoming, 1.0, config);
  const CornerLeg after = leg_of(outgoing, 1.0, config);
  const double top = std::min(before.v, after.v);
  return ramp_loss(before, curve.v) + ramp_loss(after, curve.v) +
         curve.length * (1.0 / curve.v - 1.0 / top);
}

double time_lost_by_stop(const Segment& incoming, const Segment& outgoing,
                         const MotionConfig& config) {
  return ramp_loss(leg_of(incoming, 1.0, config), 0.0) +
         ramp_loss(leg_of(outgoing, 1.0, config), 0.0);
}

OverlapGain overlap_gain(const OverlapCorner& corner, const Segment& incoming,
                         const Segment& outgoing, const MotionConfig& config) {
  const CornerLeg before = leg_of(incoming, 1.0, config);
  const CornerLeg after = leg_of(outgoing, 1.0, config);
  const OverlapRoom room{.incoming = incoming.length, .outgoing = outgoing.length};
  const double with_stop = time_with_rest(before) + time_with_rest(after);
  const auto gain_with = [&](double part) -> OverlapGain {
    const CornerLeg braking = leg_of(incoming, part, config);
    const CornerLeg starting = leg_of(outgoing, part, config);
    const PhaseRun down = ramp_down(braking.v, 0.0, 0.0, braking.ramp());
    const PhaseRun up = ramp_up(0.0, 0.0, starting.v, starting.ramp());
    const double overlap =
        overlap_duration(corner, {down.begin(), down.end()}, {up.begin(), up.end()}, room, config);
    const double gain = with_stop + overlap - time_with_rest(braking) - time_with_rest(starting);
    return {.time = gain, .jerk_part = part};
  };
  // On curves a plan uses what each place leaves it, of which constant limits know nothing: much
  // gentler ramps would cost more there than is counted here. Some of the jerk is wanted where the
  // other leg bends.
  constexpr std::array for_bends{0.97, 0.9};
  const std::array for_sums{jerk_part_allowed(corner, before.j, after.j, config)};
  const auto parts = corner.curved ? std::span<const double>(for_bends) : for_sums;
  OverlapGain best = gain_with(1.0);
  for (const double part : parts) {
    const OverlapGain gain = gain_with(part);
    if (gain.time > best.time) best = gain;
  }
  return best;
}

}  // namespace stanok::motion
