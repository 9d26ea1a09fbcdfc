#include "motion/interpolation/plan_run.h"

#include <algorithm>

#include "motion/interpolation/plan_ahead.h"

namespace stanok::motion {
namespace {

// The plan's state at the end of a phase.
PathMotion end_of(const Phase& phase) RT_SAFE {
  return {
      .s = phase.s_end, .v = phase.v_end, .a = phase.a + phase.j * phase.duration, .j = phase.j};
}

// Of limits that are so many times as high.
PaceLimits eased_pace(const PaceLimits& limits, double times) RT_SAFE {
  const auto part = static_cast<float>(1.0 / times);
  return {.use = part * limits.use,
          .velocity = part * limits.velocity,
          .thrust = part * limits.thrust,
          .coupling = part * limits.coupling};
}

bool stands_still(const PathMotion& motion) RT_SAFE {
  return motion.v == 0.0 && motion.a == 0.0;
}

}  // namespace

void PlanRun::begin(double time) RT_SAFE {
  nominal_.begin(time);
  pace_ = {};
  brake_.end();
}

bool PlanRun::rejoin(PathQueue& queue, PathCursor& cursor, const PathMotion& motion) RT_SAFE {
  if (!nominal_.rejoin(queue, cursor, motion)) return false;
  pace_ = {};
  brake_.end();
  return true;
}

bool PlanRun::rejoin_at_pace(PathQueue& queue, PathCursor& cursor, const PathMotion& motion,
                             double asked) RT_SAFE {
  while (cursor.has_phase() && cursor.phase(queue).s_end <= motion.s) cursor.pass_phase(queue);
  if (!is_paced(queue, cursor) || cursor.phase(queue).s > motion.s) return false;
  const Phase& phase = cursor.phase(queue);
  const double t = time_at(phase, motion.s);
  const PathMotion planned = motion_at(phase, t);
  Pace pace{.rate = 0.0};
  if (!stands_still(motion)) {
    if (planned.v <= 0.0) return false;
    pace.rate = motion.v / planned.v;
    pace.change = (motion.a - pace.rate * pace.rate * planned.a) / planned.v;
    if (!goes_on_from(pace, phase.pace, cycle_s_)) return false;
  } else if (planned.v <= 0.0) {
    pace.rate = asked;
  }
  nominal_.begin(t);
  pace_ = pace;
  brake_.end();
  return true;
}

bool PlanRun::rejoin_at_start(PathQueue& queue, PathCursor& cursor, const PathMotion& motion)
    RT_SAFE {
  while (cursor.has_phase() && cursor.phase(queue).s < motion.s) cursor.pass_phase(queue);
  if (!cursor.has_phase() || cursor.phase(queue).s != motion.s) return false;
  const Phase& phase = cursor.phase(queue);
  if (!phase.pace.holds() && phase.v != motion.v) return false;
  begin();
  pace_.rate = std::min(motion.v / phase.v, 1.0);
  return true;
}

void PlanRun::start_at(const PathQueue& queue, const PathCursor& cursor, const PathMotion& motion,
                       double asked) RT_SAFE {
  const Phase& phase = cursor.phase(queue);
  if (stands_still(motion) && phase.v == 0.0 && motion.s == phase.s) pace_ = {.rate = asked};
}

double PlanRun::advance(PathQueue& queue, PathCursor& cursor, double target, UsedLimits used,
                        double time, PathMotion& motion) RT_SAFE {
  if (used == UsedLimits::of_stops) used_ = used;
  if (target == 1.0 && is_nominal()) return nominal_.advance(queue, cursor, time, motion);
  return advance_at_pace(queue, cursor, target, time, motion);
}

PaceStep PlanRun::next_step(const PathQueue& queue, const PathCursor& cursor, double target,
                            double time, double s) RT_SAFE {
  if (pace_.rate == target && pace_.change == 0.0) return keep_pace(pace_, time);
  const PaceRoom room = pace_room(queue, cursor, s, nominal_.time(), time);
  // What a stop has changed with its own limits is taken away with them.
  const bool is_over = target > 0.0 && goes_on_from(pace_, room.here, time);
  if (is_over) used_ = UsedLimits::of_axes;
  if (used_ == UsedLimits::of_axes) return step_pace(pace_, target, room.here, room.ahead, time);
  return step_pace(pace_, target, eased_pace(room.here, stop_limits_),
                   eased_pace(room.ahead, stop_limits_), time);
}

double PlanRun::advance_at_pace(PathQueue& queue, PathCursor& cursor, double target, double time,
                                PathMotion& motion) RT_SAFE {
  if (!cursor.has_phase()) return time;
  const PaceStep step = next_step(queue, cursor, target, time, motion.s);
  return follow(queue, cursor, step, time, Ends::where_ramps_begin, motion);
}

std::optional<double> PlanRun::stop(PathQueue& queue, PathCursor& cursor, double time,
                                    PathMotion& motion) RT_SAFE {
  if (!cursor.has_phase()) return time;
  if (time != cycle_s_) {
    if (!brake_.is_on()) return std::nullopt;
    return follow(queue, cursor, rest_of_step(time), time, Ends::with_chunk, motion);
  }
  if (!brake_.is_on() && !brake_.begin(queue, cursor, nominal_.time(), pace_)) return std::nullopt;
  const PaceStep step = brake_.brake(queue, cursor, nominal_.time(), pace_);
  second_ = step.second;
  const double left = follow(queue, cursor, step, time, Ends::with_chunk, motion);
  if (pace_.rests()) brake_.end();
  return left;
}

double PlanRun::release(PathQueue& queue, PathCursor& cursor, double time, PathMotion& motion)
    RT_SAFE {
  if (!cursor.has_phase()) return time;
  if (time != cycle_s_)
    return follow(queue, cursor, rest_of_step(time), time, Ends::with_chunk, motion);
  const PaceStep step = brake_.release(queue, cursor, nominal_.time(), pace_);
  second_ = step.second;
  const double left = follow(queue, cursor, step, time, Ends::with_chunk, motion);
  if (pace_.change == 0.0) brake_.end();
  return left;
}

// Of a step that came to the end of a chunk.
PaceStep PlanRun::rest_of_step(double time) const RT_SAFE {
  PaceStep step{.from = pace_, .second = second_, .to = {}};
  step.to = step.after(time);
  step.advance = time * (pace_.rate + time * (0.5 * pace_.change + time * second_ / 6.0));
  step.advance = std::max(step.advance, 0.0);
  return step;
}

double PlanRun::follow(PathQueue& queue, PathCursor& cursor, const PaceStep& step, double time,
                       Ends ends_at, PathMotion& motion) RT_SAFE {
  double t = nominal_.time() + step.advance;  // within the current phase
  while (t >= cursor.phase(queue).duration) {
    const Phase phase = cursor.phase(queue);
    t -= phase.duration;
    cursor.pass_phase(queue);
    const bool meets_ramps = ends_at == Ends::where_ramps_begin && phase.pace.holds();
    const bool ends = !cursor.has_phase() || (meets_ramps && !is_paced(queue, cursor));
    if (!ends) continue;
    const double used = step.time_of(step.advance - t, time);
    nominal_.begin();
    pace_ = step.after(used);
    motion = at_pace(end_of(phase), pace_, step.second);
    if (!cursor.has_phase()) motion.s = cursor.chunk().length;
    return time - used;
  }
  nominal_.begin(t);
  pace_ = step.to;
  motion = at_pace(motion_at(cursor.phase(queue), t), pace_, step.second);
  if (pace_.rests()) motion.v = motion.a = 0.0;
  cursor.go_to(queue, motion.s);
  return 0.0;
}

}  // namespace stanok::motion
