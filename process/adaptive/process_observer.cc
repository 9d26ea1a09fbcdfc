#include "process/adaptive/process_observer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stanok::process {
namespace {

using motion::CutReference;
using motion::PowerDoubt;

// Of the idle power: less is drawn by no spindle at speed, however warm its bearings are.
constexpr double idle_least_part = 0.7;
constexpr double below_idle_s = 0.3;
constexpr double lags = 3.0;
// By which the exponent of the force may be larger than it is taken to be.
constexpr double exponent_doubt = 1.1;
// The mean force of a stretch, of itself.
constexpr double measured_within = 0.018;
constexpr double feed_least = 1e-9;

}  // namespace

void ProcessObserver::look(const Inputs& inputs) RT_SAFE {
  feed_max_ = reference_max_ = std::numeric_limits<double>::infinity();
  doubt_ = PowerDoubt::none;
  if (!std::isfinite(inputs.power_w)) {
    doubt_ = PowerDoubt::lost;
    return;
  }
  count_.learn(inputs.power_w);
  if (is_below_idle(inputs)) {
    doubt_ = PowerDoubt::below_idle;
    return;
  }
  if (!inputs.cuts) {
    ratchet_.leave_cut();
    fallen_.reset();
    is_learnt_ = is_learnt_ && !inputs.is_rapid;
    return;
  }
  const double settling_s = inputs.revolution_s + lags * config_.power_lag_s +
                            config_.power_answer_s + inputs.measuring_s;
  reference_max_ = feed_by_reference(inputs);
  const bool answers = ratchet_.look({.cycle_s = inputs.cycle_s,
                                      .force_n = inputs.force_n,
                                      .wanted_n = inputs.wanted_n,
                                      .count_n = count_.count_w() / inputs.watt_per_newton,
                                      .feed = inputs.feed,
                                      .feed_max = std::min(reference_max_, inputs.feed_max),
                                      .settling_s = settling_s,
                                      .follows = inputs.follows});
  const bool stays = fallen_.look({.cycle_s = inputs.cycle_s,
                                   .force_n = inputs.force_n,
                                   .feed = inputs.feed,
                                   .feed_exponent = config_.feed_exponent,
                                   .settling_s = settling_s,
                                   .is_at_minimum = inputs.is_at_minimum});
  if (!answers) doubt_ = PowerDoubt::no_answer;
  if (stays) doubt_ = PowerDoubt::stays_high;
  learn_reference();
  feed_max_ = std::min(ratchet_.ceiling(), reference_max_);
}

bool ProcessObserver::is_below_idle(const Inputs& inputs) RT_SAFE {
  const double lacking_w = idle_least_part * inputs.power_idle_w - inputs.power_w;
  const bool is_below =
      inputs.is_at_speed && lacking_w > SensorCount::flicker_counts * count_.count_w();
  below_idle_s_ = is_below ? below_idle_s_ + inputs.cycle_s : 0.0;
  return below_idle_s_ > lags * config_.power_lag_s + below_idle_s;
}

// The heaviest of this cut; until one is known that of the cut before.
void ProcessObserver::learn_reference() RT_SAFE {
  const Measured now = ratchet_.measured();
  if (now.force_n <= 0.0) return;
  const double expected_n = taken_.force_n * std::pow(now.feed / std::max(taken_.feed, feed_least),
                                                      config_.feed_exponent);
  if (is_learnt_ && now.force_n <= expected_n) return;
  taken_ = now;
  is_learnt_ = true;
}

double ProcessObserver::feed_by_reference(const Inputs& inputs) RT_SAFE {
  const double lightest = std::min((1.0 + measured_within) * (1.0 - config_.lighter_max), 1.0);
  reference_ = taken_.force_n > 0.0 ? CutReference::cut : CutReference::programmed;
  if (lightest <= 0.0) return std::numeric_limits<double>::infinity();
  if (reference_ == CutReference::programmed)
    return inputs.feed_programmed * std::pow(lightest, -1.0 / config_.feed_exponent);
  const double more = inputs.wanted_n / (taken_.force_n * lightest);
  const double exponent =
      more > 1.0 ? exponent_doubt * config_.feed_exponent : config_.feed_exponent;
  return taken_.feed * std::pow(more, 1.0 / exponent);
}

bool ProcessObserver::is_at_reference(double feed) const RT_SAFE {
  constexpr double rests_within = 1e-3;
  return feed >= (1.0 - rests_within) * reference_max_;
}

double ProcessObserver::worst_part() const RT_SAFE {
  if (reference_ != CutReference::cut || config_.lighter_max >= 1.0) return 0.0;
  const double by_step = std::pow(1.0 + config_.feed_step, config_.feed_exponent);
  return std::max(by_step, 1.0 / (1.0 - config_.lighter_max));
}

}  // namespace stanok::process
