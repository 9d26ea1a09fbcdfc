#include "channels/spindle.h"

#include <algorithm>

namespace stanok::channels {

void Spindle::command(const lang::SpindleCommand& command) RT_SAFE {
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

double Spindle::target() const RT_SAFE {
  if (direction_ == 0 || programmed_ == 0.0) return 0.0;
  return direction_ * std::clamp(programmed_ * override_, speed_min_, speed_max_);
}

void Spindle::advance(double period_s) RT_SAFE {
  const double wanted = target();
  const double step = acceleration_ * period_s;
  if (acceleration_ <= 0.0) {
    speed_ = wanted;
  } else {
    speed_ += std::clamp(wanted - speed_, -step, step);
  }
}

}  // namespace stanok::channels
