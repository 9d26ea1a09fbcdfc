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

bool stands_still(const PathMotion& motion) RT_SAFE {
  return motion.v == 0.0 && motion.a == 0.0;
}

}  // namespace

void PlanRun::begin(double time) RT_SAFE {
  nominal_.begin(time);
  pace_ = {};
}

bool PlanRun::rejoin(PathQueue& queue, PathCursor& cursor, const PathMotion& motion) RT_SAFE {
  if (!nominal_.rejoin(queue, cursor, motion)) return false;
  pace_ = {};
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

double PlanRun::advance(PathQueue& queue, PathCursor& cursor, double target, double time,
                        PathMotion& motion) RT_SAFE {
  if (target == 1.0 && is_nominal()) return nominal_.advance(queue, cursor, time, motion);
  return advance_at_pace(queue, cursor, target, time, motion);
}

PaceStep PlanRun::next_step(const PathQueue& queue, const PathCursor& cursor, double target,
                            double time, double s) const RT_SAFE {
  if (pace_.rate == target && pace_.change == 0.0) return keep_pace(pace_, time);
  const PaceRoom room = pace_room(queue, cursor, s, nominal_.time(), time);
  return step_pace(pace_, target, room.here, room.ahead, time);
}

double PlanRun::advance_at_pace(PathQueue& queue, PathCursor& cursor, double target, double time,
                                PathMotion& motion) RT_SAFE {
  if (!cursor.has_phase()) return time;
  const PaceStep step = next_step(queue, cursor, target, time, motion.s);
  double t = nominal_.time() + step.advance;  // within the current phase
  while (t >= cursor.phase(queue).duration) {
    const Phase phase = cursor.phase(queue);
    t -= phase.duration;
    cursor.pass_phase(queue);
    const bool ends = !cursor.has_phase() || (phase.pace.holds() && !is_paced(queue, cursor));
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
