#include "channels/axes/spindle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::channels {

void Spindle::command(const lang::SpindleCommand& command) RT_SAFE {
  go_on();
  cutting_speed_ = command.cutting_speed_m_per_min;
  switch (command.action) {
    case lang::SpindleAction::set_speed:
      programmed_ = command.speed_rev_per_min;
      break;
    case lang::SpindleAction::clockwise:
      programmed_ = command.speed_rev_per_min;
      direction_ = 1;
      break;
    case lang::SpindleAction::counter_clockwise:
      programmed_ = command.speed_rev_per_min;
      direction_ = -1;
      break;
    case lang::SpindleAction::stop:
    case lang::SpindleAction::orient:
      direction_ = 0;
      break;
  }
}

void Spindle::command(const lang::CuttingSpeedMode& mode) RT_SAFE {
  cutting_speed_ = mode.constant ? mode.speed_m_per_min : 0.0;
  speed_limit_ = mode.constant ? mode.limit_rev_per_min : 0.0;
}

void Spindle::run_at(double rev_per_min) RT_SAFE {
  programmed_ = rev_per_min;
  cutting_speed_ = 0.0;
}

// v = pi D n / 1000. At the centre the limits give the speed.
void Spindle::follow_diameter(double diameter_mm) RT_SAFE {
  if (cutting_speed_ <= 0.0) return;
  constexpr double mm_per_m = 1000.0;
  const double wanted = mm_per_m * cutting_speed_ / (std::numbers::pi * diameter_mm);
  programmed_ = std::clamp(wanted, speeds_.min, speeds_.max);
}

double Spindle::target() const RT_SAFE {
  if (rests_ || direction_ == 0 || programmed_ == 0.0) return 0.0;
  const double limit = speed_limit_ > 0.0 ? std::min(speed_limit_, speeds_.max) : speeds_.max;
  const double commanded = std::max(speeds_.min, std::min(programmed_ * override_, limit));
  return direction_ * std::clamp(share_ * commanded, -speeds_.max, speeds_.max);
}

void Spindle::stop_within(double turns) RT_SAFE {
  // v^2 / 2a turns, v in rev/min, a in rev/min/s.
  acceleration_asked_ = turns > 0.0 ? 0.5 * speed_ * speed_ / (seconds_per_minute * turns) : 0.0;
  share_ = 0.0;
}

void Spindle::turn_back(double factor, double acceleration) RT_SAFE {
  acceleration_asked_ = acceleration;
  share_ = -factor;
}

void Spindle::turn_out(double rev_per_min, double acceleration) RT_SAFE {
  go_on();
  cutting_speed_ = 0.0;
  programmed_ = std::abs(rev_per_min);
  direction_ = rev_per_min < 0.0 ? -1 : 1;
  acceleration_asked_ = acceleration;
}

void Spindle::go_on() RT_SAFE {
  acceleration_asked_ = 0.0;
  share_ = 1.0;
}

void Spindle::set_angle(double angle_deg) RT_SAFE {
  angle_deg_ = angle_deg - full_turn_deg * std::floor(angle_deg / full_turn_deg);
  if (angle_deg_ >= full_turn_deg) angle_deg_ = 0.0;  // the sum of a tiny negative angle rounds up
}

void Spindle::advance(double period_s) RT_SAFE {
  const double before = speed_;
  const double wanted = target();
  const bool is_softer = acceleration_asked_ > 0.0 && acceleration_asked_ < acceleration_;
  const double step = (is_softer ? acceleration_asked_ : acceleration_) * period_s;
  if (acceleration_ <= 0.0) {
    speed_ = wanted;
  } else {
    speed_ += std::clamp(wanted - speed_, -step, step);
  }
  if (before == 0.0 && speed_ == 0.0) return;
  const double travel_deg = deg_per_s_of_rev_per_min * 0.5 * (before + speed_) * period_s;
  turns_ += travel_deg / full_turn_deg;
  set_angle(angle_deg_ + travel_deg);
}

}  // namespace stanok::channels
