#include "motion/interpolation/override_planner.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
namespace {

// Speeds that differ by less count as equal.
constexpr double equal_speeds = 1e-9;

constexpr double spindle_room = 1.05;

// A stop that would come to rest so few cycles before the end of the known path is made to end
// there.
constexpr double stop_cycles = 3.0;

bool is_faster(double v, double cap) RT_SAFE {
  return v > cap * (1.0 + equal_speeds);
}

double way_of_run(const PhaseRun& run, double s) RT_SAFE {
  return run.size() == 0 ? 0.0 : run[run.size() - 1].s_end - s;
}

// Whether the acceleration is within the limits, and a deceleration can be taken away before the
// motion turns back.
bool can_slow_down(const PathMotion& from, const RampLimits& limits) RT_SAFE {
  const double rounding = 1e-9 * (1.0 + from.v);
  return !is_faster(std::abs(from.a), limits.a) &&
         eased_speed(from.v, from.a, limits.j) > -rounding;
}

// The highest speed within a change of speed from `from`.
double highest_speed_of_change(const PathMotion& from, double v_target, double j) RT_SAFE {
  return std::max({from.v, v_target, from.a > 0.0 ? eased_speed(from.v, from.a, j) : 0.0});
}

// Where a run comes down to speed v for the last time: its start when it is never faster, nowhere
// (infinity) when it stays faster.
double place_of_speed(const PhaseRun& run, double v) RT_SAFE {
  for (std::size_t k = run.size(); k > 0; --k) {
    const Phase& phase = run[k - 1];
    if (phase.v_end > v) return k == run.size() ? unlimited : phase.s_end;
    if (phase.v < v && phase.a <= 0.0) continue;
    // Falling through v within the phase: v + a t + j t^2 / 2, the later root.
    const double root2 = phase.a * phase.a - 2.0 * phase.j * (phase.v - v);
    if (root2 < 0.0) continue;
    const double t =
        phase.j == 0.0 ? (v - phase.v) / phase.a : (-phase.a - std::sqrt(root2)) / phase.j;
    if (t >= 0.0 && t <= phase.duration) return motion_at(phase, t).s;
  }
  return run[0].s;
}

// The fastest place of a run.
PathMotion peak_of(const PhaseRun& run) RT_SAFE {
  PathMotion peak{.s = run[0].s, .v = run[0].v};
  for (const Phase& phase : run) {
    const bool turns = phase.a > 0.0 && phase.j < 0.0;
    const double t = turns ? std::min(phase.duration, -phase.a / phase.j) : phase.duration;
    const PathMotion motion = motion_at(phase, t);
    if (motion.v > peak.v) peak = motion;
  }
  return peak;
}

// Speed at s, for a place where the run has not yet come to its peak.
double speed_at(const PhaseRun& run, double s) RT_SAFE {
  for (const Phase& phase : run) {
    if (phase.s_end < s) continue;
    double low = 0.0;
    double high = phase.duration;
    constexpr int halvings = 40;
    for (int k = 0; k < halvings; ++k) {
      const double t = 0.5 * (low + high);
      (motion_at(phase, t).s < s ? low : high) = t;
    }
    return motion_at(phase, high).v;
  }
  return run[run.size() - 1].v_end;
}

}  // namespace

void OverridePlanner::forget() RT_SAFE {
  has_plan_ = false;
  reach_ = {};
}

bool OverridePlanner::take_over_braking(const PathQueue& queue, const PathCursor& cursor,
                                        double wall, const PathMotion& motion, UsedLimits used)
    RT_SAFE {
  const std::optional<PhaseRun> run = brake_.find(queue, cursor, wall, motion, used);
  if (!run) return false;
  brake_.restart();
  forget();
  plans_[current_].clear();
  plans_[current_].add(*run);
  has_plan_ = true;
  plan_caps_ = Caps::hard;
  return true;
}

bool OverridePlanner::advance(const PathQueue& queue, const PathCursor& cursor,
                              const FeedControl& control, UsedLimits used, const PathWall& wall,
                              double time, PathMotion& motion, double& left) RT_SAFE {
  extend_reach(control);
  reach_.stop_limits = used == UsedLimits::of_stops ? stop_limits_ : 1.0;
  sight_.look(queue, cursor, control, reach_, wall);
  if (find_plan(control, time, motion)) {
    current_ = 1 - current_;
    has_plan_ = true;
    plan_caps_ = draft_caps_;
    plan_control_ = control;
    if (plan_caps_ == Caps::asked) narrow_reach(control);
  } else if (!has_plan_) {
    return false;
  }
  left = plans_[current_].run(time, motion);
  return true;
}

// A spindle whose speed changes would change the limits in every cycle, as would the highest feed
// of force control that follows it: they are given some room.
void OverridePlanner::extend_reach(const FeedControl& control) RT_SAFE {
  reach_.feed_override = std::max(reach_.feed_override, control.feed_override);
  if (control.spindle_rev_per_min > reach_.rev_per_min)
    reach_.rev_per_min = spindle_room * control.spindle_rev_per_min;
  if (control.controlled_max_per_s > reach_.controlled_per_s)
    reach_.controlled_per_s = spindle_room * control.controlled_max_per_s;
}

void OverridePlanner::narrow_reach(const FeedControl& control) RT_SAFE {
  reach_.feed_override = std::max(1.0, control.feed_override);
  if (control.spindle_rev_per_min * spindle_room * spindle_room < reach_.rev_per_min)
    reach_.rev_per_min = spindle_room * control.spindle_rev_per_min;
  if (control.controlled_max_per_s * spindle_room * spindle_room < reach_.controlled_per_s)
    reach_.controlled_per_s = spindle_room * control.controlled_max_per_s;
}

double OverridePlanner::cap(std::size_t segment, Caps caps) RT_SAFE {
  return caps == Caps::asked ? sight_.asked_speed(segment) : sight_.hard_speed(segment);
}

// Drafts a plan that serves the operator better than the current one; false: there is none.
bool OverridePlanner::find_plan(const FeedControl& control, double time, const PathMotion& motion)
    RT_SAFE {
  const bool stands = motion.v == 0.0 && motion.a == 0.0;
  const double asked = control.hold ? 0.0 : sight_.asked_speed(0);
  if (asked <= 0.0) {
    draft_caps_ = Caps::hard;
    return !(stands && has_plan_) && try_speed(motion, 0.0, time, Caps::hard).is_safe;
  }
  draft_caps_ = Caps::asked;
  const RestSearch search = try_speed(motion, asked, time, Caps::asked);
  if (search.is_safe) return true;
  const double slower = search.binding_speed;
  if (slower > 0.0 && slower < asked && try_speed(motion, slower, time, Caps::asked).is_safe)
    return true;
  if (stands && (try_hop(motion) || try_creep(motion, asked, time))) return true;
  if (has_plan_ && plan_caps_ == Caps::asked && plan_control_ == control) return false;
  // The current plan was found for another override: slow down to this one, at once if it can.
  draft().clear();
  if (find_rest(motion, sight_.segment_at(motion.s, 0), Caps::asked).is_safe) return true;
  draft_caps_ = Caps::hard;
  return try_speed(motion, asked, time, Caps::hard).is_safe;
}

// Drafts: for `time` towards speed v, then to rest.
OverridePlanner::RestSearch OverridePlanner::try_speed(const PathMotion& from, double v,
                                                       double time, Caps caps) RT_SAFE {
  const std::size_t first = sight_.segment_at(from.s, 0);
  RampLimits limits = sight_.ramp(first);
  PhaseRun run;
  PathMotion then;
  std::size_t last = first;
  for (bool settled = false; !settled;) {  // ends: limits only shrink, over finitely many segments
    draft().clear();
    run = change_speed(from, v, limits);
    then = draft().add_part(run, from, v, time);
    settled = true;
    const std::size_t end = sight_.segment_at(then.s, last);
    while (last < end) {
      const RampLimits lower = lower_of(limits, sight_.ramp(++last));
      settled = settled && lower.a >= limits.a && lower.j >= limits.j;
      limits = lower;
    }
  }
  if (!can_slow_down(from, limits) || then.s > sight_.end(last)) return {};
  const double v_high = std::max({from.v, then.v,
                                  std::min(highest_speed_of_change(from, v, limits.j),
                                           std::max(from.v, then.v) + limits.a * time)});
  const bool slows = v < from.v && from.a <= 0.0;  // and may be slow enough where it must be
  for (std::size_t segment = first; segment <= last; ++segment) {
    const double v_cap = cap(segment, caps);
    if (is_faster(v_high, v_cap) && !(slows && keeps(run, first, last, caps)))
      return {.binding_speed = v_cap};
  }
  return find_rest(then, sight_.segment_at(then.s, first), caps);
}

// Drafts a slow start from rest, close before a segment of low limits, which a cycle of full jerk
// would pass too fast.
bool OverridePlanner::try_creep(const PathMotion& from, double v, double time) RT_SAFE {
  constexpr int tries = 12;
  for (int k = 0; k < tries; ++k) {
    v *= 0.25;
    if (try_speed(from, v, time, Caps::asked).is_safe) return true;
  }
  return false;
}

// Drafts a short move from rest to the end of the known path, for which a cycle is too coarse.
bool OverridePlanner::try_hop(const PathMotion& from) RT_SAFE {
  constexpr std::size_t segments = 8;
  if (sight_.size() > segments) return false;
  RampLimits limits = sight_.ramp(0);
  double v_max = sight_.asked_speed(0);
  for (std::size_t segment = 1; segment < sight_.size(); ++segment) {
    limits = lower_of(limits, sight_.ramp(segment));
    v_max = std::min(v_max, sight_.asked_speed(segment));
  }
  const double wall = sight_.end(sight_.size() - 1);
  if (!(wall > from.s) || v_max <= 0.0) return false;
  const double top = peak_speed(0.0, 0.0, wall - from.s, limits, limits, v_max);
  if (top <= 0.0) return false;
  const PhaseRun up = ramp_up(from.s, 0.0, top, limits);
  const PhaseRun down = ramp_down(top, wall, 0.0, limits);
  draft().clear();
  draft().add(up);
  draft().add_hold(up[up.size() - 1].s_end, down[0].s, top);
  draft().add(down);
  return true;
}

// Adds a way to rest to the draft: at once, or, where a segment ahead is too slow or would spoil
// the brake with its limits, first down to the speed of that segment, from there on the same again.
OverridePlanner::RestSearch OverridePlanner::find_rest(PathMotion from, std::size_t segment,
                                                       Caps caps) RT_SAFE {
  constexpr int stages_max = 8;
  RestSearch search;
  for (int stage = 0; stage < stages_max && draft().has_room(); ++stage) {
    const BrakingRange range = survey(from, segment, caps);
    if (stage == 0) search.binding_speed = range.binding_speed;
    if (range.fits && can_slow_down(from, range.limits) &&
        keeps(change_speed(from, 0.0, range.limits), segment, range.last, caps)) {
      if (!stop_at_wall(from, segment, range, caps)) stop(from, segment, range, caps);
      search.is_safe = true;
      return search;
    }
    const Tight& tight = range.tight;
    if (!tight.found || !can_slow_down(from, tight.limits)) {
      if (from.a == 0.0 || !ease(from, segment, caps)) return search;
      continue;
    }
    const PhaseRun run = change_speed(from, tight.v, tight.limits);
    search.binding_speed = cap(tight.segment, caps);
    if (!keeps(run, segment, tight.segment - 1, caps)) return search;
    draft().add(run);
    const double reached = from.s + way_of_run(run, from.s);
    if (tight.v <= 0.0) {
      search.is_safe = true;
      return search;
    }
    segment = tight.segment;
    from = {.s = sight_.start(segment), .v = tight.v};
    draft().add_hold(reached, from.s, tight.v);
  }
  return search;
}

// Looks over the braking distance from a state, segment by segment, as the limits shrink.
OverridePlanner::BrakingRange OverridePlanner::survey(const PathMotion& from, std::size_t segment,
                                                      Caps caps) RT_SAFE {
  BrakingRange range{.last = segment, .limits = sight_.ramp(segment)};
  double rest = from.s + way_of_run(change_speed(from, 0.0, range.limits), from.s);
  while (rest > sight_.end(range.last)) {
    if (range.last + 1 == sight_.size()) return range;  // the end of what is known
    const std::size_t next = ++range.last;
    const double v_cap = cap(next, caps);
    if (is_faster(highest_speed_of_change(from, 0.0, range.limits.j), v_cap)) {
      const double eased = std::max(eased_speed(from.v, from.a, range.limits.j), 0.0);
      const double v = from.a < 0.0 ? std::min(v_cap, eased) : v_cap;
      const double slack =
          sight_.start(next) - from.s - way_of_run(change_speed(from, v, range.limits), from.s);
      range.binding_speed = v_cap;
      if (slack < 0.0) return range;
      // A faster segment behind a slower one must wait until the slower one is served.
      const Tight& tight = range.tight;
      if (!tight.found || (slack < tight.slack && v <= tight.v)) {
        range.tight = {
            .found = true, .segment = next, .slack = slack, .v = v, .limits = range.limits};
      }
    }
    const RampLimits lower = lower_of(range.limits, sight_.ramp(next));
    if (lower.a < range.limits.a || lower.j < range.limits.j) {
      range.limits = lower;
      rest = from.s + way_of_run(change_speed(from, 0.0, lower), from.s);
    }
  }
  range.fits = true;
  return range;
}

// Whether a run, which at most speeds up first and then slows down, and its last speed held from
// there on, keep the speed of every segment.
bool OverridePlanner::keeps(const PhaseRun& run, std::size_t first, std::size_t last, Caps caps)
    RT_SAFE {
  if (run.size() == 0) return true;  // the current speed is held, which the caller knows to be kept
  const PathMotion peak = peak_of(run);
  for (std::size_t segment = first; segment <= last; ++segment) {
    const double v_cap = cap(segment, caps) * (1.0 + equal_speeds);
    if (peak.v <= v_cap) continue;
    const double begin = std::max(sight_.start(segment), run[0].s);
    const double end = sight_.end(segment);
    if (end <= peak.s) {
      if (speed_at(run, end) > v_cap) return false;
    } else if (begin < peak.s || place_of_speed(run, v_cap) > begin) {
      return false;
    }
  }
  return true;
}

// Takes the acceleration away at once, before segments that do not allow it.
bool OverridePlanner::ease(PathMotion& from, std::size_t& segment, Caps caps) RT_SAFE {
  RampLimits limits = sight_.ramp(segment);
  PhaseRun run;
  std::size_t last = segment;
  for (bool settled = false; !settled;) {  // ends as in try_speed
    const double v = eased_speed(from.v, from.a, limits.j);
    if (v < 0.0) return false;
    run = change_speed(from, v, limits);
    settled = true;
    const std::size_t end = sight_.segment_at(from.s + way_of_run(run, from.s), last);
    while (last < end) {
      const RampLimits lower = lower_of(limits, sight_.ramp(++last));
      settled = settled && lower.j >= limits.j;
      limits = lower;
    }
  }
  if (is_faster(std::abs(from.a), limits.a) || run.size() == 0) return false;
  const Phase& end = run[run.size() - 1];
  if (end.s_end > sight_.end(last)) return false;
  if (!keeps(run, segment, last, caps)) return false;
  draft().add(run);
  from = {.s = end.s_end, .v = end.v_end};
  segment = sight_.segment_at(from.s, segment);
  return true;
}

// Close before the end of the known path: goes on at the current speed, where all segments allow
// it, and brakes so that it ends there exactly.
bool OverridePlanner::stop_at_wall(const PathMotion& from, std::size_t segment,
                                   const BrakingRange& range, Caps caps) RT_SAFE {
  if (from.a != 0.0 || range.last + 1 != sight_.size()) return false;
  const double wall = sight_.end(range.last);
  const double brake = wall - way_of_run(change_speed(from, 0.0, range.limits), from.s);
  if (brake <= from.s || brake > from.s + from.v * stop_cycles * cycle_s_) return false;
  for (std::size_t k = segment; k <= range.last; ++k) {
    if (is_faster(from.v, cap(k, caps))) return false;
  }
  draft().add_hold(from.s, brake, from.v);
  draft().add(change_speed({.s = brake, .v = from.v}, 0.0, range.limits));
  draft().end_at(wall);
  return true;
}

// Brakes to rest. When that ends just before the end of the known path, it is made a little softer,
// so that it ends there exactly, unless it would then pass a segment too fast.
void OverridePlanner::stop(const PathMotion& from, std::size_t segment, const BrakingRange& range,
                           Caps caps) RT_SAFE {
  const PhaseRun run = change_speed(from, 0.0, range.limits);
  const double wall = sight_.end(range.last);
  const double room = wall - from.s;
  const double reach = from.v * stop_cycles * cycle_s_;
  if (range.last + 1 == sight_.size() && run.size() > 0 &&
      way_of_run(run, from.s) + reach >= room) {
    // Part of the limits: too soft, it ends behind the wall, or the deceleration there is cannot be
    // taken away before the motion turns back.
    const double least = from.a < 0.0 ? 0.5 * from.a * from.a / (from.v * range.limits.j) : 0.0;
    double soft = std::clamp(least, 0.2, 1.0);
    double hard = 1.0;
    constexpr int halvings = 50;
    for (int k = 0; k < halvings; ++k) {
      const double part = 0.5 * (soft + hard);
      const RampLimits limits{.a = part * range.limits.a, .j = part * range.limits.j};
      (way_of_run(change_speed(from, 0.0, limits), from.s) > room ? soft : hard) = part;
    }
    const PhaseRun softer =
        change_speed(from, 0.0, {.a = hard * range.limits.a, .j = hard * range.limits.j});
    if (keeps(softer, segment, range.last, caps)) {
      draft().add(softer);
      if (room - way_of_run(softer, from.s) < 1e-11) draft().end_at(wall);
      return;
    }
  }
  draft().add(run);
}

}  // namespace stanok::motion
