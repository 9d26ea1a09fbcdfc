#include "process/adaptive/idle_power_compensator.h"

#include <cmath>

namespace stanok::process {
namespace {

// A speed that differs by more is another one: its power is taken anew when it can be.
constexpr double speed_tolerance = 0.01;

}  // namespace

void IdlePowerCompensator::begin() RT_SAFE {
  settled_s_ = 0.0;
  sum_w_ = 0.0;
  count_ = 0;
}

void IdlePowerCompensator::advance(const motion::CutState& cut) RT_SAFE {
  if (cut.spindle_starts != starts_seen_) {
    starts_seen_ = cut.spindle_starts;
    is_captured_ = false;
    rev_per_min_ = 0.0;
    begin();
  }
  if (is_captured_ && std::abs(cut.rev_per_min - rev_per_min_) > speed_tolerance * rev_per_min_)
    is_captured_ = false;
  const bool cuts = cut.feed_programmed > 0.0 && cut.path_speed > 0.0;
  const bool is_steady = cut.rev_per_min > 0.0 && cut.at_speed && cut.rev_per_min == speed_seen_;
  speed_seen_ = cut.rev_per_min;
  if (is_captured_ || cuts || !is_steady || !std::isfinite(cut.power_w)) return begin();
  settled_s_ += cut.cycle_s;
  if (settled_s_ <= config_.idle_settle_s) return;
  sum_w_ += cut.power_w;
  ++count_;
  if (settled_s_ < config_.idle_settle_s + config_.idle_capture_s) return;
  power_w_ = sum_w_ / static_cast<double>(count_);
  rev_per_min_ = cut.rev_per_min;
  is_captured_ = true;
  ++captures_;
}

double IdlePowerCompensator::power_w(double rev_per_min) const RT_SAFE {
  if (rev_per_min_ <= 0.0) return 0.0;
  const double r = rev_per_min / rev_per_min_;
  const double coulomb = config_.idle_coulomb_part;
  return power_w_ * (coulomb * r + (1.0 - coulomb) * r * r);
}

}  // namespace stanok::process
