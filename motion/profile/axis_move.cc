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
  end_with(ramp_up(0.0, 0.0, top, ramp_), top, length);
}

// Behind the change of speed on with `top`, and down to rest at `length`.
void AxisMove::end_with(const PhaseRun& change, double top, double length) RT_SAFE {
  add(change);
  const double from = change.size() == 0 ? motion_.s : change[change.size() - 1].s_end;
  const PhaseRun down = ramp_down(top, length, 0.0, ramp_);
  const double cruise = down.size() == 0 ? 0.0 : down[0].s - from;
  if (cruise > 0.0) {
    phases_[size_++] = {
        .duration = cruise / top, .s = from, .v = top, .s_end = down[0].s, .v_end = top};
  }
  add(down);
}

// The way that a change to `top` and a ramp down to rest need grows with it, from that of a stop,
// which ends before the present end: the highest one that ends at `to` is found by halving.
void AxisMove::extend(double to, double speed) RT_SAFE {
  const double length = std::abs(to - from_);
  const auto rest = [&](double top) RT_SAFE {
    const PhaseRun change = change_speed(motion_, top, ramp_);
    const double changed = change.size() == 0 ? motion_.s : change[change.size() - 1].s_end;
    return changed + ramp_distance(top, 0.0, ramp_);
  };
  double low = 0.0;
  double high = speed;
  if (rest(high) > length) {
    constexpr int halvings = 48;
    for (int n = 0; n < halvings; ++n) {
      const double middle = 0.5 * (low + high);
      (rest(middle) <= length ? low : high) = middle;
    }
  } else {
    low = high;
  }
  end_ = to;
  size_ = 0;
  at_ = 0;
  t_ = 0.0;
  end_with(change_speed(motion_, low, ramp_), low, length);
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
