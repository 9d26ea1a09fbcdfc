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
// The same over the feeds of passes of several depths: the force of the edge is felt in thin chips.
constexpr double exponent_doubt_at_depth = 1.15;
// The mean force of a stretch, of itself.
constexpr double measured_within = 0.018;
constexpr double feed_least = 1e-9;
// How well the program knows the depth, of itself, and how much lighter than that the cut may be:
// together a tenth.
constexpr double depth_within = 0.05;
constexpr double lighter_at_depth = 0.045;

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
  reference_max_ = feed_by_reference(inputs);
  if (!inputs.cuts) {
    // The tool enters a cut that is known to be heavier at the feed for it.
    if (reference_ == CutReference::depth) feed_max_ = reference_max_;
    ratchet_.leave_cut();
    fallen_.reset();
    is_learnt_ = is_learnt_ && !inputs.is_rapid;
    return;
  }
  const double settling_s = inputs.revolution_s + lags * config_.power_lag_s +
                            config_.power_answer_s + inputs.measuring_s;
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

// The heaviest of this cut; until one is known that of the cut before. For its depth, where the
// program gives that: the heaviest of all.
void ProcessObserver::learn_reference() RT_SAFE {
  const Measured now = ratchet_.measured();
  if (now.force_n <= 0.0) return;
  const double by_feed =
      std::pow(now.feed / std::max(taken_.feed, feed_least), config_.feed_exponent);
  const bool is_kept = is_learnt_ || knows_depth();
  if (is_kept && now.force_n <= depth_part() * by_feed * taken_.force_n) return;
  taken_ = now;
  taken_depth_mm_ = depth_mm_;
  is_learnt_ = true;
}

double ProcessObserver::depth_part() const RT_SAFE {
  return knows_depth() ? depth_mm_ / taken_depth_mm_ : 1.0;
}

double ProcessObserver::lighter_max() const RT_SAFE {
  return reference_ == CutReference::depth ? std::min(config_.lighter_max, lighter_at_depth)
                                           : config_.lighter_max;
}

double ProcessObserver::feed_by_reference(const Inputs& inputs) RT_SAFE {
  reference_ = CutReference::programmed;
  if (taken_.force_n > 0.0) reference_ = knows_depth() ? CutReference::depth : CutReference::cut;
  const double lightest = std::min((1.0 + measured_within) * (1.0 - lighter_max()), 1.0);
  if (lightest <= 0.0) return std::numeric_limits<double>::infinity();
  if (reference_ == CutReference::programmed)
    return inputs.feed_programmed * std::pow(lightest, -1.0 / config_.feed_exponent);
  const double more = inputs.wanted_n / (depth_part() * taken_.force_n * lightest);
  const double doubt = reference_ == CutReference::depth ? exponent_doubt_at_depth : exponent_doubt;
  const double exponent =
      more > 1.0 ? doubt * config_.feed_exponent : config_.feed_exponent / doubt;
  return taken_.feed * std::pow(more, 1.0 / exponent);
}

bool ProcessObserver::is_at_reference(double feed) const RT_SAFE {
  constexpr double rests_within = 1e-3;
  return feed >= (1.0 - rests_within) * reference_max_;
}

double ProcessObserver::worst_part() const RT_SAFE {
  const bool is_measured = reference_ == CutReference::cut || reference_ == CutReference::depth;
  if (!is_measured || lighter_max() >= 1.0) return 0.0;
  const double by_step = std::pow(1.0 + config_.feed_step, config_.feed_exponent);
  const double by_depth = reference_ == CutReference::depth ? 1.0 + depth_within : 1.0;
  return std::max(by_step, by_depth / (1.0 - lighter_max()));
}

}  // namespace stanok::process
