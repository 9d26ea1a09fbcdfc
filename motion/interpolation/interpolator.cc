#include "motion/interpolation/interpolator.h"

#include <cmath>

#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

void derivatives_to_zero(JetPoint& point, const Point& values) RT_SAFE {
  for (std::size_t k = 0; k < values.size(); ++k) point[k] = kinematics::Jet(values[k]);
}

void to_axes(const kinematics::Transform* transform, const JetPoint& point, JetPoint& axes)
    RT_SAFE {
  if (transform == nullptr) {
    axes = point;
  } else {
    kinematics::inverse(*transform, point, axes);
  }
}

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

}  // namespace

Interpolator::Interpolator(const MotionConfig& config)
    : cycle_s_(config.cycle_s),
      axis_count_(config.axis_count),
      planner_(config.cycle_s),
      interruption_(config),
      synchronous_(config.cycle_s) {}

void Interpolator::stand_at(const Point& axes_M, const kinematics::Transform& transform) RT_SAFE {
  standing_axes_ = axes_M;
  last_axes_ = axes_M;
  kinematics::forward(transform, axes_M, standing_point_);
}

bool Interpolator::at_rest() const RT_SAFE {
  return is_at_rest(motion_);
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
    if (stand_mm_ > 0.0) {
      time = stand(control, time);
      out.cycle_left = time;
      if (stand_mm_ > 0.0) break;
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
  stand_mm_ = interruption_.lengths().stand_mm;
  stand_feed_ = interruption_.stand(queue, cursor_, motion_.s);
}

// Goes on along the equivalent dwell path; returns what is left of the time at its end.
double Interpolator::stand(const FeedControl& control, double time) RT_SAFE {
  const double speed =
      control.hold ? 0.0 : stand_feed_.per_s * control.feed_part(stand_feed_.rev_per_min);
  if (stand_mm_ > speed * time) {
    stand_mm_ -= speed * time;
    return 0.0;
  }
  const double left = time - stand_mm_ / speed;
  stand_mm_ = 0.0;
  return left;
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
  if (!is_synchronous()) return;
  synchronous_.begin(cursor_.chunk().coupling, cursor_.chunk().length);
  is_nominal_ = true;
  phase_time_first_ = 0.0;  // of phases that an override had left
  phase_cycles_ = 0.0;
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
  if (is_nominal_) return !cursor_.has_phase();
  const double length = cursor_.chunk().length;
  return cursor_.chunk().last ? at_rest() && motion_.s == length : motion_.s >= length;
}

bool Interpolator::knows_next(const PathQueue& queue) const RT_SAFE {
  return cursor_.chunk().last || !queue.chunks.empty();
}

double Interpolator::run(PathQueue& queue, const FeedControl& control, double time) RT_SAFE {
  if (is_synchronous()) return follow_spindle(queue, control);
  interruption_.look(queue, cursor_, motion_.s);
  // Rapid traverse does not know of force control: it runs as it was planned.
  FeedControl asked = control;
  if (cursor_.segment(queue).rapid && (is_nominal_ || at_rest())) asked.controlled_per_s = 0.0;
  const bool wants_nominal =
      overlap_ == Overlap::runs ||
      (asked.is_nominal() && follows_spindle(queue, control) && knows_next(queue) &&
       !sees_gate(queue, control) && !interruption_.is_on());
  if (!is_nominal_ && wants_nominal) rejoin_nominal(queue);
  if (is_nominal_ && wants_nominal) return run_nominal(queue, time);
  if (is_nominal_) planner_.forget();
  const double before = motion_.s;
  double left = 0.0;
  asked.hold = control.hold || interruption_.holds(cursor_.segment(queue));
  if (!planner_.advance(queue, cursor_, asked, interruption_.wall(), time, motion_, left)) {
    return run_nominal(queue, time);
  }
  is_nominal_ = false;
  // At rest at the end of the chain, to rounding: exactly there.
  constexpr double rounding = 1e-11;  // mm; its jump is far below any limit
  const double length = cursor_.chunk().length;
  if (at_rest() && std::abs(motion_.s - length) < rounding) motion_.s = length;
  advanced_ += motion_.s - before;
  cursor_.go_to(queue, motion_.s, control.closed_from_block);
  return left;
}

// Goes over to the committed phases where they stand in the very state of now: in a phase of
// constant speed, or at its start at rest.
void Interpolator::rejoin_nominal(PathQueue& queue) RT_SAFE {
  if (motion_.a != 0.0) return;
  while (cursor_.has_phase() && cursor_.phase(queue).s_end <= motion_.s) cursor_.pass_phase(queue);
  if (!cursor_.has_phase()) return;
  const Phase& phase = cursor_.phase(queue);
  if (phase.v != motion_.v || phase.a != 0.0) return;
  const bool cruises = phase.j == 0.0 && phase.v > 0.0 && phase.s <= motion_.s;
  if (!cruises && phase.s != motion_.s) return;
  phase_time_first_ = cruises ? (motion_.s - phase.s) / phase.v : 0.0;
  phase_cycles_ = 0.0;
  is_nominal_ = true;
}

// Runs committed phases for `time`; returns what is left of it at the end of the chunk.
double Interpolator::run_nominal(PathQueue& queue, double time) RT_SAFE {
  const double before = motion_.s;
  if (time == cycle_s_) {
    phase_cycles_ += 1.0;
  } else {
    phase_time_first_ += time;
  }
  while (cursor_.has_phase()) {
    const Phase& phase = cursor_.phase(queue);
    const double t = phase_time_first_ + phase_cycles_ * cycle_s_;
    if (t < phase.duration) {
      motion_ = motion_at(phase, t);
      advanced_ += motion_.s - before;
      cursor_.go_to(queue, motion_.s);
      return 0.0;
    }
    phase_time_first_ = t - phase.duration;
    phase_cycles_ = 0.0;
    motion_ = {.s = phase.s_end, .v = phase.v_end};
    cursor_.pass_phase(queue);
  }
  const double unused = phase_time_first_;
  phase_time_first_ = 0.0;
  motion_.s = cursor_.chunk().length;
  advanced_ += motion_.s - before;
  return unused;
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
      !is_nominal_ && !cursor_.chunk().last && !queue.chunks.empty() &&
      queue.segments[cursor_.segments_left()].tag.block >= control.closed_from_block;
  if (!knows_next(queue) || gate_here) {
    motion_ = {.s = length};
    return false;
  }
  if (overlap_ == Overlap::runs) {
    enter_overlapped(queue);
    return true;
  }
  overlap_ = Overlap::undecided;
  if (!is_synchronous()) cursor_.go_to(queue, length);
  const double beyond = motion_.s - length;
  const bool chain_ends = cursor_.chunk().last;
  if (chain_ends) {
    stand_mm_ = cursor_.chunk().stand_mm;
    stand_feed_ = {.per_s = cursor_.segment(queue).feed_per_s,
                   .rev_per_min = cursor_.segment(queue).process.rev_per_min};
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
  const Segment& segment = cursor_.segment(queue);
  JetPoint point;
  JetPoint axes;
  evaluate(segment, cursor_.s_in_segment(queue, motion_.s), point);
  for (std::size_t k = 0; k < point.size(); ++k) standing_point_[k] = point[k].value;
  derivatives_to_zero(point, standing_point_);
  to_axes(segment.transform, point, axes);
  unwind(segment.transform, axes);
  for (std::size_t k = 0; k < axes.size(); ++k) standing_axes_[k] = axes[k].value;
  last_tag_ = segment.tag;
  last_process_ = segment.process;
  motion_ = {};
}

void Interpolator::unwind(const kinematics::Transform* transform, JetPoint& axes) const RT_SAFE {
  if (transform == nullptr || transform->scheme == nullptr) return;
  constexpr double turn = 360.0;
  const unsigned winding = transform->scheme->winding_axes();
  for (std::size_t k = 0; winding >> k != 0; ++k) {
    if ((winding >> k & 1U) == 0) continue;
    axes[k].value += turn * std::round((last_axes_[k] - axes[k].value) / turn);
  }
}

void Interpolator::report(const PathQueue& queue, const FeedControl& control,
                          InterpolatorOutput& out) RT_SAFE {
  out.chunks_done = chunks_done_;
  out.path_advanced = advanced_;
  out.working_axes = 0;
  out.s_speed = motion_.v;
  out.at_gate = stands_at_gate(queue, control);
  out.has_lost_spindle = is_synchronous() && synchronous_.is_lost();
  if (!cursor_.has_chunk()) {
    out.state = stand_mm_ > 0.0 ? PathState::standing : PathState::idle;
    out.tag = last_tag_;
    out.feed_commanded =
        stand_mm_ > 0.0 ? stand_feed_.per_s * control.spindle_part(stand_feed_.rev_per_min) : 0.0;
    out.process = last_process_;
    derivatives_to_zero(out.point, standing_point_);
    derivatives_to_zero(out.axes, standing_axes_);
    return;
  }
  const Segment& segment = cursor_.segment(queue);
  out.state = state(queue, control);
  out.tag = segment.tag;
  out.feed_commanded =
      segment.rapid ? 0.0 : segment.feed_per_s * control.spindle_part(segment.process.rev_per_min);
  out.process = segment.process;
  if (!is_synchronous()) out.working_axes = working_axes(segment);
  JetPoint point_s;
  evaluate(segment, cursor_.s_in_segment(queue, motion_.s), point_s);
  along_time(point_s, motion_.v, motion_.a, motion_.j, axis_count_, out.point);
  if (is_synchronous()) turns_to_way(segment, point_s, out);
  if (overlap_ == Overlap::runs) add_next_chain(queue, out);
  to_axes(segment.transform, out.point, out.axes);
  unwind(segment.transform, out.axes);
  for (std::size_t k = 0; k < out.axes.size(); ++k) last_axes_[k] = out.axes[k].value;
}

// s counts turns: what is told outside is the tip's path in mm.
void Interpolator::turns_to_way(const Segment& segment, const JetPoint& point_s,
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
  if (stand_mm_ > 0.0) return PathState::standing;
  if (knows_next(queue) || control.hold) return PathState::holding;
  return PathState::starved;
}

void Interpolator::drop_path(PathQueue& queue) RT_SAFE {
  if (cursor_.has_chunk()) {
    stand_here(queue);
    ++chunks_done_;
  }
  chunks_done_ += queue.chunks.size();
  stand_mm_ = 0.0;
  cursor_.drop(queue);
  is_nominal_ = true;
  overlap_ = Overlap::undecided;
  phase_time_first_ = 0.0;
  phase_cycles_ = 0.0;
  planner_.forget();
}

}  // namespace stanok::motion
