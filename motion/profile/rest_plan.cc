#include "motion/profile/rest_plan.h"

#include <algorithm>

namespace stanok::motion {

void RestPlan::clear() RT_SAFE {
  size_ = 0;
  at_ = 0;
  t_ = 0.0;
}

bool RestPlan::has_room() const RT_SAFE {
  return size_ + PhaseRun::capacity + 1 <= capacity;
}

void RestPlan::add(const PhaseRun& run) RT_SAFE {
  for (const Phase& phase : run) phases_[size_++] = phase;
}

PathMotion RestPlan::add_part(const PhaseRun& run, const PathMotion& from, double v, double time)
    RT_SAFE {
  PathMotion motion = from;
  for (Phase phase : run) {
    if (time < phase.duration) {
      motion = motion_at(phase, time);
      phase.duration = time;
      phase.s_end = motion.s;
      phase.v_end = motion.v;
      phases_[size_++] = phase;
      return motion;
    }
    time -= phase.duration;
    phases_[size_++] = phase;
    motion = {.s = phase.s_end, .v = phase.v_end};
  }
  const double s_end = motion.s + v * time;
  add_hold(motion.s, s_end, v);
  return {.s = s_end, .v = v};
}

void RestPlan::add_hold(double s0, double s1, double v) RT_SAFE {
  if (!(s1 > s0)) return;
  phases_[size_++] = {.duration = (s1 - s0) / v, .s = s0, .v = v, .s_end = s1, .v_end = v};
}

void RestPlan::end_at(double s) RT_SAFE {
  if (size_ > 0) phases_[size_ - 1].s_end = s;
}

double RestPlan::run(double time, PathMotion& motion) RT_SAFE {
  while (at_ < size_) {
    const Phase& phase = phases_[at_];
    if (t_ + time < phase.duration) {
      t_ += time;
      motion = motion_at(phase, t_);
      motion.v = std::max(motion.v, 0.0);  // rounding just before rest
      return 0.0;
    }
    time -= phase.duration - t_;
    t_ = 0.0;
    ++at_;
    motion = {.s = phase.s_end, .v = phase.v_end};
  }
  return time;
}

void RestPlan::shift(double ds) RT_SAFE {
  for (std::size_t k = at_; k < size_; ++k) {
    phases_[k].s -= ds;
    phases_[k].s_end -= ds;
  }
}

}  // namespace stanok::motion
