#include "motion/interpolation/interpolator.h"

#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"
#include "motion/profile/speed_segment.h"

namespace stanok::motion {
namespace {

// For so long a higher feed has to be run that the plan is left for it; before a plan that is taken
// up again it is left for so long.
constexpr double worthwhile = 0.05;  // s
constexpr double settling = 0.012;   // s

// A gate lies on the path that is known.
bool sees_gate(const PathQueue& queue, const FeedControl& control) RT_SAFE {
  return control.closed_from_block != FeedControl::no_gate && !queue.segments.empty() &&
         queue.segments[queue.segments.size() - 1].tag.block >= control.closed_from_block;
}

// The spindle turns as fast as the feed of the current segment was planned for.
bool follows_spindle(const PathQueue& queue, const FeedControl& control) RT_SAFE {
  const double planned = queue.segments.front().process.rev_per_min;
  return planned <= 0.0 || planned == control.spindle_rev_per_min;
}

TapOnPath tap_on(const SpindleCoupling& coupling, const SynchronousRun& run) RT_SAFE {
  if (coupling.kind == SpindleCoupling::Kind::thread) return {};
  return {.place = run.is_in_hole() ? TapOnPath::Place::in_hole : TapOnPath::Place::before,
          .spindle = coupling.spindle,
          .lead_mm = coupling.lead_mm};
}

}  // namespace

Interpolator::Interpolator(const MotionConfig& config, PathHistory* history,
                           const kinematics::LengthChanges* lengths)
    : cycle_s_(config.cycle_s),
      axis_count_(config.axis_count),
      cursor_(history),
      plan_(config),
      planner_(config),
      interruption_(config),
      synchronous_(config.cycle_s),
      place_(lengths) {}

void Interpolator::stand_at(const Point& axes_M, const kinematics::Transform& transform) RT_SAFE {
  place_.stand_at(axes_M, transform);
}

bool Interpolator::at_rest() const RT_SAFE {
  return is_at_rest(motion_);
}

std::optional<double> Interpolator::way_into_segment(const PathQueue& queue) const RT_SAFE {
  if (!cursor_.has_chunk()) return std::nullopt;
  return cursor_.s_in_segment(queue, motion_.s);
}

void Interpolator::advance(PathQueue& queue, const FeedControl& control, InterpolatorOutput& out,
                           std::uint64_t chunk_limit) RT_SAFE {
  out.chain_ended = false;
  out.cycle_left = 0.0;
  out.spindle_order = {};
  advanced_ = 0.0;
  double time = cycle_s_;
  // Each round ends a chunk; a cycle holds only so many of them.
  constexpr int chunks_per_cycle_max = 64;
  for (int round = 0; round < chunks_per_cycle_max; ++round) {
    if (dwell_.is_on()) {
      time = dwell_.advance(control, time);
      out.cycle_left = time;
      if (dwell_.is_on()) break;
    }
    if (!cursor_.has_chunk()) {
      if (control.hold || !may_enter(queue, control, chunk_limit)) break;
      enter(queue);
    }
    if (is_interrupted(queue)) {
      begin_interruption(queue);
      continue;
    }
    time = run(queue, control, time);
    if (is_synchronous()) out.spindle_order = synchronous_.order();
    run_overlap(queue, control, chunk_limit);
    if (time > 0.0 && is_interrupted(queue)) continue;
    if (!has_run_chunk() || !finish_chunk(queue, control, out)) break;
    out.cycle_left = time;
    if (time <= 0.0) break;
  }
  report(queue, control, out);
}

void Interpolator::interrupt(const InterruptionLengths& lengths) RT_SAFE {
  interruption_.set(lengths, cursor_, motion_);
}

// At rest within the current chain where its feed is to be interrupted.
bool Interpolator::is_interrupted(const PathQueue& queue) const RT_SAFE {
  if (!interruption_.is_on() || !at_rest() || is_synchronous() || has_run_chunk()) return false;
  return interruption_.is_due(cursor_.segment(queue), motion_.s);
}

void Interpolator::begin_interruption(const PathQueue& queue) RT_SAFE {
  dwell_.begin(interruption_.lengths().stand_mm, interruption_.stand(queue, cursor_, motion_.s));
}

bool Interpolator::may_enter(const PathQueue& queue, const FeedControl& control,
                             std::uint64_t chunk_limit) const RT_SAFE {
  if (queue.chunks.empty()) return false;
  if (queue.segments[cursor_.segments_left()].tag.block >= control.closed_from_block) return false;
  const Chunk& next = queue.chunks.front();
  const bool ends_alone = next.last && next.overlap_s <= 0.0;
  return next.sequence < chunk_limit && (ends_alone || queue.chunks.size() > 1);
}

// The first chunk of a chain.
void Interpolator::enter(PathQueue& queue) RT_SAFE {
  cursor_.enter(queue);
  interruption_.begin_chain(cursor_);
  plan_.begin();  // not with phases that an override had left, nor at its pace
  if (!is_synchronous()) return;
  synchronous_.begin(cursor_.chunk().coupling, cursor_.chunk().length);
  motion_ = synchronous_.motion();
  is_on_plan_ = true;
}

// Runs for a cycle by the spindle; nothing is left of it.
double Interpolator::follow_spindle(PathQueue& queue, const FeedControl& control) RT_SAFE {
  const double before = motion_.s;
  motion_ = synchronous_.advance(spindles_[cursor_.chunk().coupling.spindle], control);
  advanced_ += std::abs(motion_.s - before);
  cursor_.go_to(queue, motion_.s);
  return 0.0;
}

// Whether the current chunk lies behind. Close to rest s comes to its end, to rounding, before the
// motion does.
bool Interpolator::has_run_chunk() const RT_SAFE {
  if (is_synchronous()) return synchronous_.is_over();
  if (is_on_plan_) return !cursor_.has_phase();
  const double length = cursor_.chunk().length;
  return cursor_.chunk().last ? at_rest() && motion_.s == length : motion_.s >= length;
}

bool Interpolator::knows_next(const PathQueue& queue) const RT_SAFE {
  return cursor_.chunk().last || !queue.chunks.empty();
}

double Interpolator::run(PathQueue& queue, const FeedControl& control, double time) RT_SAFE {
  if (is_synchronous()) return follow_spindle(queue, control);
  interruption_.look(queue, cursor_, motion_.s);
  FeedControl asked = control;
  // Rapid traverse does not know of force control: it runs as it was planned.
  if (cursor_.segment(queue).rapid && (is_on_plan_ || at_rest())) asked.controlled_per_s = 0.0;
  asked.hold = control.hold || interruption_.holds(cursor_.segment(queue));
  if (is_on_plan_) look_for_raise(queue, asked);
  asked.feed_override = std::min(asked.feed_override, planner_.override_max());
  if (!is_on_plan_) rejoin_plan(queue, asked);
  if (!is_on_plan_) time = approach_plan(queue, asked, time);
  if (const std::optional<double> left = run_stop(queue, asked, time)) return *left;
  if (is_on_plan_ && keeps_plan(queue, asked)) {
    time = run_plan(queue, asked, time);
    if (is_on_plan_ && (time <= 0.0 || !cursor_.has_phase())) return time;
    if (is_on_plan_ && keeps_plan(queue, asked)) return run_plan(queue, asked, time);
  }
  return run_under_override(queue, asked, time);
}

// Nothing is asked but what was planned.
bool Interpolator::wants_nominal(const PathQueue& queue, const FeedControl& asked) const RT_SAFE {
  if (overlap_.runs()) return true;
  const bool is_asked = asked.is_nominal() && follows_spindle(queue, asked) && knows_next(queue) &&
                        !interruption_.is_on();
  if (!is_asked) return false;
  if (!is_on_plan_ || !PlanRun::is_paced(queue, cursor_)) return !sees_gate(queue, asked);
  return gate_ahead(queue, cursor_, asked, motion_) == unlimited;
}

// Overrides alone change the pace of a plan; all else is a matter of the override planner.
bool Interpolator::may_keep_plan(const PathQueue& queue, const FeedControl& asked) const RT_SAFE {
  return asked.controlled_per_s <= 0.0 && !interruption_.is_on() && knows_next(queue) &&
         gate_ahead(queue, cursor_, asked, motion_) == unlimited;
}

// Whether the plan is run at the current place. One that uses the limits of the axes to the full is
// not left without a brake; under a higher feed, ramps are run as they are, and only what holds the
// feed becomes faster: never is a higher override slower.
bool Interpolator::keeps_plan(const PathQueue& queue, const FeedControl& asked) const RT_SAFE {
  if (!cursor_.has_phase() || PlanRun::is_paced(queue, cursor_)) return cursor_.has_phase();
  if (!plan_.is_nominal()) return false;
  if (wants_nominal(queue, asked)) return true;
  const Segment& segment = cursor_.segment(queue);
  if (!raises_feed(segment, asked) || !may_keep_plan(queue, asked)) return false;
  return !holds_feed(cursor_.phase(queue), segment) ||
         plan_to_approach(queue, asked, worthwhile).s < unlimited;
}

// Goes over to the plan where it comes to the very state of now.
void Interpolator::rejoin_plan(PathQueue& queue, const FeedControl& asked) RT_SAFE {
  if (wants_nominal(queue, asked)) is_on_plan_ = plan_.rejoin(queue, cursor_, motion_);
  // Before a gate the plan would have to be left again, and so on with ever shorter ways.
  if (is_on_plan_ || asked.hold || sees_gate(queue, asked) || !may_keep_plan(queue, asked)) return;
  const double pace = asked_pace(cursor_.segment(queue), asked);
  is_on_plan_ = plan_.rejoin_at_pace(queue, cursor_, motion_, pace);
}

// Before a plan that is to be run as it was made: comes down to its speed, and, once the speed is
// even, exactly to its start. Returns what is left of the time.
double Interpolator::approach_plan(PathQueue& queue, FeedControl& asked, double time) RT_SAFE {
  if (asked.hold || !may_keep_plan(queue, asked)) return time;
  const PlanStart start = plan_to_approach(queue, asked, settling);
  if (start.s == unlimited) return time;
  asked.feed_override = std::min(asked.feed_override, 1.0);
  if (raises_feed(cursor_.segment(queue), asked))
    is_on_plan_ = plan_.rejoin(queue, cursor_, motion_);
  if (is_on_plan_) return time;
  constexpr double even = 1e-6;  // mm/s^2
  constexpr double rounding = 1e-9;
  const bool comes_there =
      std::abs(motion_.a) < even && motion_.v > 0.0 && motion_.v <= start.v * (1.0 + rounding) &&
      start.s <= cursor_.chunk().length && start.s - motion_.s <= motion_.v * time;
  if (!comes_there) return time;
  const PathMotion before = motion_;
  const double used = (start.s - motion_.s) / motion_.v;
  double left = 0.0;
  if (used > 0.0 && !planner_.advance(queue, cursor_, asked, UsedLimits::of_axes,
                                      interruption_.wall(), used, motion_, left)) {
    return time;
  }
  if (std::abs(motion_.a) < even && std::abs(motion_.s - start.s) < rounding) {
    const double v = std::abs(motion_.v / start.v - 1.0) < rounding ? start.v : motion_.v;
    motion_ = {.s = start.s, .v = v};
    is_on_plan_ = plan_.rejoin_at_start(queue, cursor_, motion_);
  }
  advanced_ += motion_.s - before.s;
  cursor_.go_to(queue, motion_.s, asked.closed_from_block);
  return time - used;
}

// The next plan that is so near that the motion has to come to its speed now, with a while to
// spare; none: far away.
PlanStart Interpolator::plan_to_approach(const PathQueue& queue, const FeedControl& asked,
                                         double while_s) const RT_SAFE {
  const Segment& segment = cursor_.segment(queue);
  const PlanKind kind = raises_feed(segment, asked) ? PlanKind::every : PlanKind::paced;
  const double part = std::max(asked.feed_part(segment.process.rev_per_min), 1.0);
  const double highest = segment.rapid ? motion_.v : std::max(motion_.v, part * segment.feed_per_s);
  const double near =
      motion_.s + highest * while_s + rest_distance(queue, cursor_, motion_.s, highest, part);
  return next_plan_start(queue, cursor_, kind, motion_.s, near);
}

// On the plan for `time`: at the pace that is asked, or to rest, by a brake if there is one.
// Returns what is left of it where the plan ends, or the chunk, or where the plan was left.
double Interpolator::run_plan(PathQueue& queue, const FeedControl& asked, double time) RT_SAFE {
  const bool is_nominal = wants_nominal(queue, asked);
  const bool may_keep = is_nominal || may_keep_plan(queue, asked);
  const double asked_part = may_keep ? asked_pace(cursor_.segment(queue), asked) : 0.0;
  const double pace = is_nominal ? 1.0 : asked_part;
  plan_.start_at(queue, cursor_, motion_, pace);
  if (pace == 0.0 && leaves_plan(queue, asked)) return time;
  const double before = motion_.s;
  const double left = plan_.advance(queue, cursor_, pace, limits_for(queue, asked), time, motion_);
  advanced_ += motion_.s - before;
  return left;
}

// A stop along the plan, or its release when it is no longer asked; none: neither.
std::optional<double> Interpolator::run_stop(PathQueue& queue, const FeedControl& asked,
                                             double time) RT_SAFE {
  const double before = motion_.s;
  std::optional<double> left;
  if (!is_on_plan_) return left;
  if (limits_for(queue, asked) == UsedLimits::of_stops) {
    if (!plan_.stops() && !brakes_along_plan(queue, cursor_, asked, motion_)) return left;
    left = plan_.stop(queue, cursor_, time, motion_);
  } else if (plan_.stops()) {
    left = plan_.release(queue, cursor_, time, motion_);
  }
  advanced_ += motion_.s - before;
  return left;
}

// Those of stops for hold, override 0, or a path that did not arrive in time; where the feed is
// interrupted it comes to rest as it does for any change of the feed.
UsedLimits Interpolator::limits_for(const PathQueue& queue, const FeedControl& asked) const
    RT_SAFE {
  if (at_rest() || overlap_.runs() || interruption_.is_on()) return UsedLimits::of_axes;
  const bool is_stop = asked_pace(cursor_.segment(queue), asked) == 0.0 || !knows_next(queue);
  return is_stop ? UsedLimits::of_stops : UsedLimits::of_axes;
}

// An override above 100 % under which the plan would be taken up again before anything could be
// used of it is lowered until then.
void Interpolator::look_for_raise(const PathQueue& queue, const FeedControl& asked) RT_SAFE {
  planner_.bound_override(unlimited);
  if (asked.feed_override <= 1.0 || !raises_feed(cursor_.segment(queue), asked)) return;
  FeedControl lowered = asked;
  for (const double part : {1.0, 0.5, 0.25, 0.125}) {
    lowered.feed_override = 1.0 + part * (asked.feed_override - 1.0);
    if (plan_to_approach(queue, lowered, worthwhile).s < unlimited) continue;
    if (part < 1.0) planner_.bound_override(lowered.feed_override);
    return;
  }
}

// To rest: at once where there is a brake; at rest, when the plan cannot go on from there.
bool Interpolator::leaves_plan(const PathQueue& queue, const FeedControl& asked) RT_SAFE {
  if (at_rest()) {
    is_on_plan_ = wants_nominal(queue, asked) || may_keep_plan(queue, asked);
    if (!is_on_plan_) planner_.forget();
  } else {
    const double wall = gate_ahead(queue, cursor_, asked, motion_);
    is_on_plan_ =
        !planner_.take_over_braking(queue, cursor_, wall, motion_, limits_for(queue, asked));
  }
  return !is_on_plan_;
}

// By the override planner, for `time`; the plan goes on where that has nothing to offer.
double Interpolator::run_under_override(PathQueue& queue, const FeedControl& asked, double time)
    RT_SAFE {
  if (is_on_plan_) planner_.forget();
  const double before = motion_.s;
  double left = 0.0;
  is_on_plan_ = !planner_.advance(queue, cursor_, asked, limits_for(queue, asked),
                                  interruption_.wall(), time, motion_, left);
  if (is_on_plan_) left = plan_.go_on(queue, cursor_, time, motion_);
  // At rest at the end of the chain, to rounding: exactly there.
  constexpr double rounding = 1e-11;  // mm; its jump is far below any limit
  const double length = cursor_.chunk().length;
  if (at_rest() && std::abs(motion_.s - length) < rounding) motion_.s = length;
  advanced_ += motion_.s - before;
  if (!is_on_plan_) cursor_.go_to(queue, motion_.s, asked.closed_from_block);
  return left;
}

// Runs the next chain as far as it overlaps the end of the current one. It begins in the first
// cycle that comes into the overlap, or not at all.
void Interpolator::run_overlap(const PathQueue& queue, const FeedControl& control,
                               std::uint64_t chunk_limit) RT_SAFE {
  const double overlap = cursor_.chunk().overlap_s;
  if (overlap <= 0.0 || !is_on_plan_ || overlap_.is_refused()) return;
  const double begun = overlap - plan_.time_to_end(queue, cursor_, overlap);
  if (begun <= 0.0) return;
  if (overlap_.is_undecided()) {
    const bool is_asked =
        plan_.is_nominal() && (control.is_nominal() || keeps_plan(queue, control));
    if (!is_asked || !may_enter(queue, control, chunk_limit)) return overlap_.refuse();
    overlap_.begin();
  }
  advanced_ += overlap_.advance(queue, cursor_.phases_left(), begun);
}

// The current chain has ended, the next one runs already.
void Interpolator::enter_overlapped(PathQueue& queue) RT_SAFE {
  plan_.begin(cursor_.chunk().overlap_s);
  interruption_.end_chain(cursor_.chunk().length);
  cursor_.leave(queue);
  ++chunks_done_;
  cursor_.enter(queue);
  interruption_.begin_chain(cursor_);
  motion_ = overlap_.take_over();
}

// The segment behind the current one lies behind a gate.
bool Interpolator::is_next_segment_closed(const PathQueue& queue, const FeedControl& control) const
    RT_SAFE {
  const bool last_of_chunk = cursor_.segments_left() <= 1;
  if (last_of_chunk && (cursor_.chunk().last || queue.chunks.empty())) return false;
  return queue.segments[1].tag.block >= control.closed_from_block;
}

bool Interpolator::stands_at_gate(const PathQueue& queue, const FeedControl& control) const
    RT_SAFE {
  if (!at_rest()) return false;
  if (!cursor_.has_chunk()) {
    return !queue.chunks.empty() && queue.segments.front().tag.block >= control.closed_from_block;
  }
  constexpr double rounding = 1e-9;  // mm
  return is_next_segment_closed(queue, control) &&
         motion_.s >= cursor_.segment_start() + cursor_.segment(queue).length - rounding;
}

// Leaves the current chunk behind. False: the chain goes on, but its next chunk is not there or
// closed; the chunk is kept.
bool Interpolator::finish_chunk(PathQueue& queue, const FeedControl& control,
                                InterpolatorOutput& out) RT_SAFE {
  const double length = cursor_.chunk().length;
  const bool gate_here =
      !is_on_plan_ && !cursor_.chunk().last && !queue.chunks.empty() &&
      queue.segments[cursor_.segments_left()].tag.block >= control.closed_from_block;
  if (!knows_next(queue) || gate_here) {
    motion_ = {.s = length};
    return false;
  }
  if (overlap_.runs()) {
    enter_overlapped(queue);
    return true;
  }
  overlap_.forget();
  if (!is_synchronous()) cursor_.go_to(queue, length);
  const double beyond = motion_.s - length;
  const bool chain_ends = cursor_.chunk().last;
  if (chain_ends) {
    dwell_.begin(cursor_.chunk().stand_mm,
                 {.per_s = cursor_.segment(queue).feed_per_s,
                  .rev_per_min = cursor_.segment(queue).process.rev_per_min});
    interruption_.end_chain(length);
    stand_here(queue);
    out.chain_ended = true;
  }
  cursor_.leave(queue);
  ++chunks_done_;
  if (chain_ends) return true;
  cursor_.enter(queue);
  planner_.shift(length);
  interruption_.shift(length);
  motion_.s = beyond;
  cursor_.go_to(queue, beyond, control.closed_from_block);
  return true;
}

// The axes stand at the current point of the path from now on.
void Interpolator::stand_here(const PathQueue& queue) RT_SAFE {
  place_.stand_on(cursor_.segment(queue), cursor_.s_in_segment(queue, motion_.s));
  motion_ = {};
}

void Interpolator::report(const PathQueue& queue, const FeedControl& control,
                          InterpolatorOutput& out) RT_SAFE {
  out.chunks_done = chunks_done_;
  out.path_advanced = advanced_;
  out.working_axes = 0;
  out.s_speed = motion_.v;
  out.at_gate = stands_at_gate(queue, control);
  out.is_led_by_spindle = is_synchronous() && motion_.v != 0.0;
  out.has_lost_spindle = is_synchronous() && synchronous_.is_lost();
  out.tap = is_synchronous() ? tap_on(cursor_.chunk().coupling, synchronous_) : TapOnPath{};
  if (!cursor_.has_chunk()) return report_standing(control, out);
  const Segment& segment = cursor_.segment(queue);
  out.state = state(queue, control);
  out.tag = segment.tag;
  out.feed_commanded =
      segment.rapid ? 0.0 : segment.feed_per_s * control.spindle_part(segment.process.rev_per_min);
  out.on_arc = segment.geometry.kind == SegmentKind::arc;
  out.process = segment.process;
  if (!is_synchronous()) out.working_axes = working_axes(segment);
  JetPoint point_s;
  evaluate(segment, cursor_.s_in_segment(queue, motion_.s), point_s);
  along_time(point_s, motion_.v, motion_.a, motion_.j, axis_count_, out.point);
  if (is_synchronous()) turns_to_path(segment, point_s, out);
  if (overlap_.runs()) {
    out.s_speed = overlap_.add(queue.segments[cursor_.segments_left()], axis_count_, out.point);
  }
  place_.follow(segment, out.point, out.axes);
}

void Interpolator::report_standing(const FeedControl& control, InterpolatorOutput& out) const
    RT_SAFE {
  out.state = dwell_.is_on() ? PathState::standing : PathState::idle;
  out.tag = place_.tag();
  out.on_arc = false;
  out.feed_commanded = dwell_.feed_commanded(control);
  out.process = place_.process();
  place_.standing(out.point, out.axes);
}

// s counts turns: what is told outside is the tip's path in mm.
void Interpolator::turns_to_path(const Segment& segment, const JetPoint& point_s,
                                 InterpolatorOutput& out) const RT_SAFE {
  double squared = 0.0;
  for (int k = 0; k < axis_count_; ++k) {
    if (segment.geometry.metric.counts(k)) squared += point_s[k].first * point_s[k].first;
  }
  const double lead = std::sqrt(squared);
  out.s_speed = lead * std::abs(motion_.v);
  out.path_advanced = lead * advanced_;
  out.feed_commanded *= lead;
}

PathState Interpolator::state(const PathQueue& queue, const FeedControl& control) const RT_SAFE {
  if (!at_rest() || advanced_ > 0.0) return PathState::moving;
  if (dwell_.is_on()) return PathState::standing;
  if (knows_next(queue) || control.hold) return PathState::holding;
  return PathState::starved;
}

void Interpolator::drop_path(PathQueue& queue) RT_SAFE {
  if (cursor_.has_chunk()) {
    stand_here(queue);
    ++chunks_done_;
  }
  chunks_done_ += queue.chunks.size();
  dwell_.drop();
  cursor_.drop(queue);
  is_on_plan_ = true;
  overlap_.forget();
  plan_.begin();
  planner_.forget();
}

}  // namespace stanok::motion
