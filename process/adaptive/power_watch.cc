#include "process/adaptive/power_watch.h"

#include <cmath>

namespace stanok::process {
namespace {

constexpr double feed_change = 0.1;

// A living sensor shows the change of a chip within a part of a revolution and few of its lags; a
// bus may hold a value for a while.
constexpr double revolutions = 0.5;
constexpr double lags = 3.0;
constexpr double held_s = 0.1;

}  // namespace

PowerTrust PowerWatch::look(const Inputs& inputs) RT_SAFE {
  if (!std::isfinite(inputs.power_w)) return PowerTrust::lost;
  if (inputs.power_w != power_w_ || !inputs.cuts) {
    power_w_ = inputs.power_w;
    feed_ = inputs.feed_per_rev;
    suspicion_s_ = 0.0;
    return PowerTrust::good;
  }
  if (std::abs(inputs.feed_per_rev - feed_) <= feed_change * feed_) return PowerTrust::good;
  suspicion_s_ += inputs.cycle_s;
  const double patience_s = revolutions * inputs.revolution_s + lags * config_.power_lag_s + held_s;
  return suspicion_s_ < patience_s ? PowerTrust::good : PowerTrust::stuck;
}

}  // namespace stanok::process
