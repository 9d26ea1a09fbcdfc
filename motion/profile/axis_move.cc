#include "motion/profile/axis_move.h"

#include <cmath>

namespace stanok::motion {

void AxisMove::begin(double from, double to, const AxisMoveLimits& limits) RT_SAFE {
  from_ = from;
  end_ = to;
  sign_ = to < from ? -1.0 : 1.0;
  ramp_ = limits.ramp;
  motion_ = {};
  size_ = 0;
  at_ = 0;
  t_ = 0.0;
  const double length = std::abs(to - from);
  if (length <= 0.0) return;
  const double top = peak_speed(0.0, 0.0, length, ramp_, ramp_, limits.speed);
  const PhaseRun up = ramp_up(0.0, 0.0, top, ramp_);
  const PhaseRun down = ramp_down(top, length, 0.0, ramp_);
  add(up);
  const double cruise = down[0].s - up[up.size() - 1].s_end;
  if (cruise > 0.0) {
    phases_[size_++] = {.duration = cruise / top,
                        .s = up[up.size() - 1].s_end,
                        .v = top,
                        .s_end = down[0].s,
                        .v_end = top};
  }
  add(down);
}

void AxisMove::stop() RT_SAFE {
  if (is_at_rest()) return;
  const PhaseRun run = change_speed(motion_, 0.0, ramp_);
  size_ = 0;
  at_ = 0;
  t_ = 0.0;
  add(run);
  const double rest = run.size() == 0 ? motion_.s : run[run.size() - 1].s_end;
  end_ = from_ + sign_ * rest;
}

void AxisMove::add(const PhaseRun& run) RT_SAFE {
  for (const Phase& phase : run) phases_[size_++] = phase;
}

void AxisMove::advance(double time_s) RT_SAFE {
  t_ += time_s;
  while (at_ < size_ && t_ >= phases_[at_].duration) t_ -= phases_[at_++].duration;
  if (is_at_rest()) {
    motion_ = {};
    return;
  }
  motion_ = motion_at(phases_[at_], t_);
}

kinematics::Jet AxisMove::position() const RT_SAFE {
  if (is_at_rest()) return {end_};
  return {from_ + sign_ * motion_.s, sign_ * motion_.v, sign_ * motion_.a, sign_ * motion_.j};
}

}  // namespace stanok::motion
