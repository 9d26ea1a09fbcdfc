#include "motion/interpolation/nominal_run.h"

namespace stanok::motion {

void NominalRun::begin(double time) RT_SAFE {
  time_first_ = time;
  cycles_ = 0.0;
}

bool NominalRun::rejoin(PathQueue& queue, PathCursor& cursor, const PathMotion& motion) RT_SAFE {
  if (motion.a != 0.0) return false;
  while (cursor.has_phase() && cursor.phase(queue).s_end <= motion.s) cursor.pass_phase(queue);
  if (!cursor.has_phase()) return false;
  const Phase& phase = cursor.phase(queue);
  if (phase.v != motion.v || phase.a != 0.0) return false;
  const bool cruises = phase.j == 0.0 && phase.v > 0.0 && phase.s <= motion.s;
  if (!cruises && phase.s != motion.s) return false;
  begin(cruises ? (motion.s - phase.s) / phase.v : 0.0);
  return true;
}

double NominalRun::advance(PathQueue& queue, PathCursor& cursor, double time, PathMotion& motion)
    RT_SAFE {
  if (time == cycle_s_) {
    cycles_ += 1.0;
  } else {
    time_first_ += time;
  }
  while (cursor.has_phase()) {
    const Phase& phase = cursor.phase(queue);
    const double t = time_first_ + cycles_ * cycle_s_;
    if (t < phase.duration) {
      motion = motion_at(phase, t);
      cursor.go_to(queue, motion.s);
      return 0.0;
    }
    begin(t - phase.duration);
    motion = {.s = phase.s_end, .v = phase.v_end};
    cursor.pass_phase(queue);
  }
  const double unused = time_first_;
  time_first_ = 0.0;
  motion.s = cursor.chunk().length;
  return unused;
}

double NominalRun::time_to_end(const PathQueue& queue, const PathCursor& cursor,
                               double farthest) const RT_SAFE {
  if (!cursor.has_phase()) return 0.0;
  double time = -(time_first_ + cycles_ * cycle_s_);
  for (std::uint32_t k = 0; k < cursor.phases_left() && time <= farthest; ++k) {
    time += queue.phases[k].duration;
  }
  return time;
}

}  // namespace stanok::motion
