#include "motion/threads/thread_law.h"

#include <algorithm>

namespace stanok::motion {

using kinematics::Jet;

void ThreadLaw::begin(const RunInStart& start) RT_SAFE {
  start_ = start;
  is_in_law_ = false;
}

void ThreadLaw::begin_at(double place, double turns, double out_speed) RT_SAFE {
  start_.direction = out_speed > 0.0 ? -1.0 : 1.0;
  start_.origin = start_.direction * turns - place;
  is_in_law_ = true;
}

Jet ThreadLaw::advance(const SpindleMotion& spindle) RT_SAFE {
  const double direction = start_.direction;
  const Jet law{place(spindle), direction * spindle.speed, direction * spindle.acceleration,
                direction * spindle.jerk};
  if (is_in_law_) return law;
  const PhaseRun& ramp = start_.ramp;
  const double speed = start_.ramp_speed;
  const double half = ramp[ramp.size() - 1].s_end;
  const Jet time{(law.value + half) / speed, law.first / speed, law.second / speed,
                 law.third / speed};
  double t = std::max(time.value, 0.0);
  std::size_t k = 0;
  while (k < ramp.size() && t >= ramp[k].duration) t -= ramp[k++].duration;
  is_in_law_ = k == ramp.size();
  if (is_in_law_) return law;
  const PathMotion m = motion_at(ramp[k], t);
  return kinematics::compose(time, m.s, m.v, m.a, m.j);
}

}  // namespace stanok::motion
