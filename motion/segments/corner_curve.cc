#include "motion/segments/corner_curve.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "motion/bounds/segment_bounds.h"
#include "motion/path/blend.h"
#include "motion/path/geometry.h"
#include "motion/path/swing.h"
#include "motion/segments/corner.h"

namespace stanok::motion {
namespace {

// A swing is taken where it loses so many times less than the other way, blend or stop.
constexpr double gain_min = 1.3;

// Shorter rests between two curves are not worth a segment of their own; their curve gives way.
constexpr double rest_min = 1e-4;

// The shortest rest of a block between its two curves, when `left` remains of it.
double rest_wanted(double left) {
  return std::min(rest_min, 0.125 * left);
}

// How far a curve may reach: it takes all that is left rather than leave a tiny rest.
double reach_allowed(const CornerPlace& place) {
  const double half = 0.5 * place.outgoing.length;
  return place.left - half < rest_wanted(place.left) ? place.left : half;
}

// How a curve between two lines passes their corner, mm: its own distance, and how much farther off
// the chord between two setpoints is, (v T)^2 q'' / 8. The speed is the highest that any plan may
// have there: where nothing is left for a change of speed.
struct CornerPass {
  double distance = 0.0;
  double chord = 0.0;
};

CornerPass pass_of(const CornerPlace& place, std::span<const Segment> curve,
                   const MotionConfig& config) {
  constexpr double override_max = 2.0;
  const Geometry& incoming = place.incoming.geometry;
  JetPoint middle;
  const Segment& at_middle = curve[curve.size() / 2];
  evaluate_at_parameter(at_middle, curve.size() == 1 ? 0.5 : 0.0, middle);
  double distance2 = 0.0;
  double bend2 = 0.0;
  for (const int axis : config.geometry) {
    if (axis < 0) continue;
    const double distance = middle[axis].value - incoming.end[axis];
    distance2 += distance * distance;
    bend2 += middle[axis].second * middle[axis].second;
  }
  const double curvature = at_middle.bounds.curvature;
  const double by_curvature = curvature > 0.0 ? 1.0 / std::sqrt(curvature) : unlimited;
  const double way = std::min(override_max * at_middle.feed_per_s, by_curvature) * config.cycle_s;
  return {std::sqrt(distance2), 0.125 * way * way * std::sqrt(bend2)};
}

// The part of the tolerance used with which chords on the curve keep the whole one, too; at most 1.
double part_for_chords(const CornerPlace& place, std::span<const Segment> curve,
                       const Tolerance& tolerance, const MotionConfig& config) {
  constexpr double part_min = 0.1;
  constexpr double unseen = 1e-6;  // mm; chords of an exact path
  if (!is_between_lines(place.incoming, place.outgoing)) return 1.0;
  const CornerPass pass = pass_of(place, curve, config);
  const double allowed = std::max(tolerance.mm, unseen);
  if (pass.distance + pass.chord <= allowed) return 1.0;
  constexpr double less = 0.998;  // so that few attempts do
  return std::clamp(less * (allowed - pass.chord) / pass.distance, part_min, 1.0);
}

// A segment of a curve from one block to the next.
Segment corner_segment(const CornerPlace& place, const Shape& shape, const MotionConfig& config) {
  Segment segment = place.outgoing;
  segment.tag = place.incoming.tag;
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  segment.feed_per_s = std::min(place.incoming.feed_per_s, place.outgoing.feed_per_s);
  segment.rapid = place.incoming.rapid && place.outgoing.rapid;
  if (place.incoming.feed_per_s < place.outgoing.feed_per_s)
    segment.process = place.incoming.process;
  segment.bounds = segment_bounds(segment, config);
  return segment;
}

// A curve by its shape, which `fit` finds for the greatest reach allowed: it leaves no tiny rest of
// the incoming block, its chords keep the tolerance and it stays within the soft limits.
template <typename Fit>
std::optional<CornerCurve> curve_by(const Fit& fit, const CornerPlace& place,
                                    const Tolerance& tolerance, const MotionConfig& config) {
  const auto fit_with_rest = [&](const Tolerance& used) -> std::optional<CornerCurve> {
    const double rest = rest_wanted(place.left);
    auto found = fit(reach_allowed(place), used);
    if (found && found->reach < place.left && place.left - found->reach < rest)
      found = fit(place.left - rest, used);
    if (!found) return std::nullopt;
    CornerCurve curve;
    curve.reach = found->reach;
    for (const Shape& shape : found->parts)
      curve.segments.push_back(corner_segment(place, shape, config));
    return curve;
  };
  Tolerance used = tolerance;
  auto curve = fit_with_rest(used);
  constexpr int attempts = 8;  // a smaller curve is bent more, where the feed sets its speed
  for (int k = 0; k < attempts && curve; ++k) {
    const double part = part_for_chords(place, curve->segments, tolerance, config);
    if (part == 1.0) break;
    used = {used.mm * part, used.deg * part};
    curve = fit_with_rest(used);
  }
  if (!curve) return curve;
  const auto is_beyond = [&](const Segment& segment) {
    return soft_limit_excess(segment, config).has_value();
  };
  if (std::ranges::any_of(curve->segments, is_beyond)) return std::nullopt;
  return curve;
}

// A corner as it were if nothing but the axes limited the speed: what is found there holds at every
// feed.
class CornerAtAnyFeed {
 public:
  CornerAtAnyFeed(const CornerPlace& place, const MotionConfig& config)
      : config_(config), incoming_(place.incoming), outgoing_(place.outgoing) {
    incoming_.feed_per_s = unlimited;
    outgoing_.feed_per_s = unlimited;
  }

  [[nodiscard]] static Passage passage(const CornerCurve& curve) {
    return passage_of(curve.segments, unlimited);
  }
  [[nodiscard]] bool keeps_speed(const Passage& passage) const {
    return motion::keeps_speed(incoming_, passage, outgoing_, config_);
  }
  [[nodiscard]] double time_lost(const Passage& passage) const {
    return motion::time_lost(incoming_, passage, outgoing_, config_);
  }

 private:
  const MotionConfig& config_;
  Segment incoming_;
  Segment outgoing_;
};

// A swing to the full tolerance between two lines, by the closed forms of its speed and of the
// blend's; near enough to spare the making of most that gain nothing. None where it is not longer
// than the blend.
std::optional<Passage> foreseen_swing(const CornerPlace& place, double blend_reach, double blend_v,
                                      const Tolerance& tolerance, const MotionConfig& config) {
  constexpr double faster_at_equal_reach = 0.72;  // (1.166 / 3.097)^(1/3)
  const double full = full_swing_reach(place.incoming, place.outgoing, tolerance, config);
  const double reach = std::min(full, reach_allowed(place));
  if (reach <= blend_reach) return std::nullopt;
  const double ratio = std::cbrt(reach * reach / (blend_reach * blend_reach));
  return Passage{
      .v = faster_at_equal_reach * ratio * blend_v, .feed = unlimited, .length = 2.0 * reach};
}

std::optional<CornerCurve> blend_at(const CornerPlace& place, const Tolerance& tolerance,
                                    const MotionConfig& config) {
  const auto fit = [&](double reach_max, const Tolerance& used) -> std::optional<Swing> {
    const auto blend = fit_blend(place.incoming, place.outgoing, reach_max, used, config);
    if (!blend) return std::nullopt;
    return Swing{.parts = {blend->shape}, .reach = blend->reach};
  };
  return curve_by(fit, place, tolerance, config);
}

std::optional<CornerCurve> swing_at(const CornerPlace& place, const Tolerance& tolerance,
                                    const MotionConfig& config) {
  const auto fit = [&](double reach_max, const Tolerance& used) {
    return fit_swing(place.incoming, place.outgoing, reach_max, used, config);
  };
  auto curve = curve_by(fit, place, tolerance, config);
  if (curve) curve->caution = gain_min;
  return curve;
}

// A swing that is passed faster than `blend` where two blocks, of which one is not straight, have
// no kink to speak of, only a step of curvature.
std::optional<CornerCurve> swing_at_step(const CornerPlace& place, const Tolerance& tolerance,
                                         const MotionConfig& config, const CornerCurve& blend) {
  constexpr double faster = 1.02;
  constexpr double longer = 1.25;
  auto swing = swing_at(place, tolerance, config);
  if (!swing || swing->reach >= longer * blend.reach) return std::nullopt;
  const bool is_faster =
      CornerAtAnyFeed::passage(*swing).v > faster * CornerAtAnyFeed::passage(blend).v;
  return is_faster ? std::move(swing) : std::nullopt;
}

// A swing that loses less time than `blend` by far.
std::optional<CornerCurve> swing_at_kink(const CornerPlace& place, const CornerAtAnyFeed& free,
                                         const Tolerance& tolerance, const MotionConfig& config,
                                         const CornerCurve& blend) {
  const Passage by_blend = CornerAtAnyFeed::passage(blend);
  const double lost_max = free.time_lost(by_blend) / gain_min;
  if (is_between_lines(place.incoming, place.outgoing)) {
    const auto foreseen = foreseen_swing(place, blend.reach, by_blend.v, tolerance, config);
    if (!foreseen || free.time_lost(*foreseen) >= lost_max) return std::nullopt;
  }
  auto swing = swing_at(place, tolerance, config);
  const bool gains = swing && free.time_lost(CornerAtAnyFeed::passage(*swing)) < lost_max;
  return gains ? std::move(swing) : std::nullopt;
}

// A swing that is worth to be taken instead of `blend`.
std::optional<CornerCurve> swing_instead_of(const CornerCurve& blend, const CornerPlace& place,
                                            const Tolerance& tolerance,
                                            const MotionConfig& config) {
  const CornerAtAnyFeed free(place, config);
  if (!free.keeps_speed(CornerAtAnyFeed::passage(blend)))
    return swing_at_kink(place, free, tolerance, config, blend);
  return is_between_lines(place.incoming, place.outgoing)
             ? std::nullopt
             : swing_at_step(place, tolerance, config, blend);
}

// At the feeds of the blocks.
void judge(const CornerPlace& place, const MotionConfig& config, CornerCurve& curve) {
  const Passage passage = passage_of(curve.segments, curve.segments.front().feed_per_s);
  curve.keeps_speed = keeps_speed(place.incoming, passage, place.outgoing, config);
  curve.time_lost = time_lost(place.incoming, passage, place.outgoing, config);
}

}  // namespace

std::optional<CornerCurve> corner_curve(const CornerPlace& place, const Tolerance& tolerance,
                                        const MotionConfig& config) {
  const bool has_law =
      place.incoming.process.law != nullptr || place.outgoing.process.law != nullptr;
  auto curve = blend_at(place, tolerance, config);
  if (!has_law) {
    auto swing = curve ? swing_instead_of(*curve, place, tolerance, config)
                       : swing_at(place, tolerance, config);
    if (swing) curve = std::move(swing);
  }
  if (curve) judge(place, config, *curve);
  return curve;
}

}  // namespace stanok::motion
