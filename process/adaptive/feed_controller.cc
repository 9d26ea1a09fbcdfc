#include "process/adaptive/feed_controller.h"

#include <algorithm>
#include <cmath>

namespace stanok::process {
namespace {

// The force counts as held within this part of its setpoint.
constexpr double held_within = 0.1;

// The integrator is given no more than a force of e^-0.5 or e^1 times the setpoint at once.
constexpr double error_low = -0.5;
constexpr double error_high = 1.0;

// Lags of the sensor until its power is that of the cut.
constexpr double lags_to_settle = 3.0;

}  // namespace

void FeedController::reset() RT_SAFE {
  *this = FeedController(config_);
}

void FeedController::begin_with(double feed_per_rev) RT_SAFE {
  feed_ = feed_per_rev;
}

void FeedController::scale(double factor) RT_SAFE {
  feed_ *= factor;
  feed_held_ *= factor;
  is_scaled_ = true;
  scaled_s_ = 0.0;
}

void FeedController::advance(const FeedControllerInputs& inputs) RT_SAFE {
  feed_ = std::clamp(feed_, inputs.feed_min, inputs.feed_max);
  following_s_ = inputs.follows ? following_s_ + inputs.cycle_s : 0.0;
  if (!inputs.cuts) {
    if (cutting_s_ > 0.0 && feed_held_ > 0.0)
      feed_ = std::clamp(feed_held_, inputs.feed_min, inputs.feed_max);
    feed_held_ = 0.0;
    cutting_s_ = 0.0;
    is_at_minimum_ = false;
    return;
  }
  cutting_s_ += inputs.cycle_s;
  const double error = std::log(std::max(1.0 + inputs.deviation, std::exp(error_low)));
  if (std::abs(error) < held_within) feed_held_ = feed_;
  const double settling_s = inputs.revolution_s + lags_to_settle * config_.power_lag_s;
  scaled_s_ += inputs.cycle_s;
  is_scaled_ = is_scaled_ && scaled_s_ < settling_s;
  if (is_scaled_) return;
  // More feed only when the power is that of a full chip at the feed asked for.
  const bool is_settled = std::min(cutting_s_, following_s_) >= settling_s;
  if (error < 0.0 && !is_settled) return;
  const double dead_time_s = 0.5 * inputs.revolution_s + config_.power_lag_s + inputs.delay_s;
  const double rate = config_.gain / dead_time_s / config_.feed_exponent;
  const double change = -rate * std::min(error, error_high) * inputs.cycle_s;
  feed_ = std::clamp(feed_ * std::exp(change), inputs.feed_min, inputs.feed_max);
  is_at_minimum_ = feed_ <= inputs.feed_min && error > held_within;
}

}  // namespace stanok::process
