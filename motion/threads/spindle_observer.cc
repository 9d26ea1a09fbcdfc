// Gains of the fading-memory filter for the interval between two angles
// (motion/threads/spindle_observer.h).
#include "motion/threads/spindle_observer.h"

#include <cmath>

#include "base/units.h"

namespace stanok::motion {
namespace {

// Along the cubic.
SpindleMotion along_cubic(const SpindleMotion& m, double t) RT_SAFE {
  return {.turns = m.turns + t * (m.speed + t * (m.acceleration / 2.0 + t * m.jerk / 6.0)),
          .speed = m.speed + t * (m.acceleration + t * m.jerk / 2.0),
          .acceleration = m.acceleration + t * m.jerk,
          .jerk = m.jerk};
}

}  // namespace

SpindleMotion SpindleObserver::ahead(double time_s, const SpindleMotion& commanded) const RT_SAFE {
  const SpindleMotion beside = along_cubic(beside_, time_s);
  return {.turns = commanded.turns + beside.turns,
          .speed = commanded.speed + beside.speed,
          .acceleration = commanded.acceleration + beside.acceleration,
          .jerk = commanded.jerk + beside.jerk,
          .speed_wanted = commanded.speed_wanted};
}

void SpindleObserver::advance(double period_s, const SpindleMotion& commanded) RT_SAFE {
  commanded_ = commanded;
  beside_ = along_cubic(beside_, period_s);
  since_observed_s_ += period_s;
}

void SpindleObserver::observe(double angle_deg) RT_SAFE {
  const double beside = angle_deg / full_turn_deg - commanded_.turns;
  if (!has_begun_) {
    beside_ = {.turns = beside};
    has_begun_ = true;
    since_observed_s_ = 0.0;
    return;
  }
  const double T = since_observed_s_;
  if (T <= 0.0) return;
  double excess = beside - beside_.turns;
  excess -= std::round(excess);
  const double theta = std::exp(-bandwidth * T);
  const double p = 1.0 - theta;
  beside_.turns += (1.0 - theta * theta * theta * theta) * excess;
  beside_.speed += p * p * (11.0 + theta * (14.0 + 11.0 * theta)) / 6.0 * excess / T;
  beside_.acceleration += 2.0 * p * p * p * (1.0 + theta) * excess / (T * T);
  beside_.jerk += p * p * p * p * excess / (T * T * T);
  since_observed_s_ = 0.0;
}

}  // namespace stanok::motion
