#include "motion/interpolation/plan_trace.h"

#include <cmath>

#include "motion/path/geometry.h"
#include "motion/path/sampling.h"

namespace stanok::motion {

PlanTrace::PlanTrace(const MotionConfig& config) : config_(config), nodes_(capacity + 2) {}

void PlanTrace::begin(double step) RT_SAFE {
  step_ = step;
  per_step_ = 1.0 / step;
  size_ = 0;
}

void PlanTrace::look(const PathQueue& queue, const PathCursor& cursor, double elapsed, double time,
                     double ahead) RT_SAFE {
  evaluations_ = 0;
  queue_ = &queue;
  const bool is_last = cursor.chunk().last || queue.chunks.empty();
  chunk_length_ = cursor.chunk().length;
  own_phases_ = cursor.phases_left();
  phases_ = own_phases_ + (is_last ? 0 : queue.chunks.front().phases);
  segments_ = cursor.segments_seen(queue);
  ends_at_rest_ = cursor.chunk().last || (!is_last && queue.chunks.front().last);
  front_ = {.phase_begin = -elapsed, .segment_begin = cursor.segment_start()};
  Place place = front_;
  const std::size_t first = at(time).interval;
  const std::size_t last = static_cast<std::size_t>((time + ahead) * per_step_) + 1;
  const std::size_t end = std::min(last, first + capacity);
  while (size_ < end && evaluations_ + evaluations_interval <= evaluations_max) {
    const double from = step_ * static_cast<double>(size_) - time;
    if (go_to(place, from)) {
      add(place, time);
    } else if (ends_at_rest_) {
      rest();
    } else {
      return;
    }
  }
}

bool PlanTrace::measure(double ahead, Axes& axes) RT_SAFE {
  Place place = front_;
  if (!go_to(place, ahead)) return false;
  evaluate_at(place, ahead, axes);
  return true;
}

// With s along the current chunk.
Phase PlanTrace::phase_at(std::size_t index) const RT_SAFE {
  Phase phase = queue_->phases[index];
  if (index < own_phases_) return phase;
  phase.s += chunk_length_;
  phase.s_end += chunk_length_;
  return phase;
}

// To the phase and the segment of an instant that is not behind. False: behind all that is known.
bool PlanTrace::go_to(Place& place, double time) const RT_SAFE {
  while (place.phase < phases_ && place.phase_begin + queue_->phases[place.phase].duration <= time)
    place.phase_begin += queue_->phases[place.phase++].duration;
  if (place.phase >= phases_) return false;
  const Phase phase = phase_at(place.phase);
  const double s = motion_at(phase, std::max(time - place.phase_begin, 0.0)).s;
  while (place.segment + 1 < segments_ &&
         place.segment_begin + queue_->segments[place.segment].length <= s)
    place.segment_begin += queue_->segments[place.segment++].length;
  return true;
}

// The place and the time of the next evaluation: the end of the interval, of the phase or of the
// segment, whatever comes first.
PlanTrace::Step PlanTrace::step_from(const Place& place, double t, double end) const RT_SAFE {
  const Phase phase = phase_at(place.phase);
  const double phase_end = place.phase_begin + phase.duration;
  Step step{.until = std::min(phase_end, end)};
  const double segment_end = place.segment_begin + queue_->segments[place.segment].length;
  const double s_until = motion_at(phase, step.until - place.phase_begin).s;
  step.crosses = segment_end < s_until && place.segment + 1 < segments_;
  if (step.crosses)
    step.until = std::clamp(place.phase_begin + time_at(phase, segment_end), t, step.until);
  step.segment_end = segment_end;
  return step;
}

void PlanTrace::include(const Axes& axes, Node& here) const RT_SAFE {
  for (int k = 0; k < config_.axis_count; ++k) {
    here.jerk[k].low = std::min(here.jerk[k].low, axes[k].jerk);
    here.jerk[k].high = std::max(here.jerk[k].high, axes[k].jerk);
  }
}

void PlanTrace::begin_node(const Axes& axes, Node& here) const RT_SAFE {
  here.bend = 0.0;
  for (int k = 0; k < config_.axis_count; ++k) {
    here.jerk[k] = {axes[k].jerk, axes[k].jerk};
    here.velocity[k] = axes[k].velocity;
    here.acceleration[k] = here.bent[k] = axes[k].acceleration;
  }
}

// Of the jerk of an axis, as a part of its limit.
double PlanTrace::largest_change(const Axes& before, const Axes& axes) const RT_SAFE {
  double change = 0.0;
  for (int k = 0; k < config_.axis_count; ++k)
    change = std::max(change, std::abs(axes[k].jerk - before[k].jerk) / config_.axes[k].jerk_max);
  return change;
}

// The next interval, which begins at `place`. Between the ends of phases and of segments the jerk
// is smooth: what it comes to counts from both sides of each.
void PlanTrace::add(Place& place, double time) RT_SAFE {
  const double begin = step_ * static_cast<double>(size_) - time;
  const double end = begin + step_;
  Node& here = node(size_);
  Node& next = node(size_ + 1);
  Axes axes;
  double change_max = 0.0;
  evaluate_at(place, begin, axes);
  begin_node(axes, here);
  const std::size_t most = evaluations_ + evaluations_interval - 3;
  double t = begin;
  while (t < end) {
    Step step = step_from(place, t, end);
    if (evaluations_ >= most) {  // so short are the segments that not each of them is looked at
      step.until = end;
      if (!go_to(place, end)) break;
    }
    evaluate_at(place, step.until, axes);
    include(axes, here);
    t = step.until;
    if (t >= end) break;
    if (step.crosses) {
      place.segment_begin = step.segment_end;
      ++place.segment;
    } else if (!go_to(place, t)) {
      axes = {};  // at rest, if the chain ends there
      include(axes, here);
      break;
    }
    const Axes before = axes;
    evaluate_at(place, t, axes);
    include(axes, here);
    const double change = largest_change(before, axes);
    if (change <= change_max || t <= begin) continue;
    change_max = change;
    here.bend = (t - begin) / step_;
    for (int k = 0; k < config_.axis_count; ++k) here.bent[k] = axes[k].acceleration;
  }
  for (int k = 0; k < config_.axis_count; ++k) {
    next.velocity[k] = axes[k].velocity;
    next.acceleration[k] = axes[k].acceleration;
  }
  ++size_;
}

// Behind the end of the chain.
void PlanTrace::rest() RT_SAFE {
  if (size_ == 0) node(0) = {};
  node(size_).jerk = {};
  node(size_).bend = 0.0;
  node(size_).bent = {};
  node(size_ + 1) = {};
  ++size_;
}

void PlanTrace::evaluate_at(const Place& place, double time, Axes& axes) RT_SAFE {
  ++evaluations_;
  const Phase phase = phase_at(place.phase);
  const double t = std::clamp(time - place.phase_begin, 0.0, phase.duration);
  const PathMotion motion = motion_at(phase, t);
  const Segment& segment = queue_->segments[place.segment];
  // The stored ends of a segment have no derivatives of their own: just beside them.
  constexpr double beside = 1e-12;
  const double s = std::clamp(motion.s - place.segment_begin, beside * segment.length,
                              (1.0 - beside) * segment.length);
  JetPoint point_s;
  JetPoint point;
  JetPoint axes_M;
  evaluate(segment, s, point_s);
  along_time(point_s, motion.v, motion.a, motion.j, config_.axis_count, point);
  to_machine(segment, point, axes_M);
  for (int k = 0; k < config_.axis_count; ++k)
    axes[k] = {axes_M[k].first, axes_M[k].second, axes_M[k].third};
}

}  // namespace stanok::motion
