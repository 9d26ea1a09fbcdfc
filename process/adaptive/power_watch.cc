#include "process/adaptive/power_watch.h"

#include <algorithm>
#include <cmath>

namespace stanok::process {
namespace {

// Parts of the feed that change before the power is judged: at first, where it only flickers;
// after a trial in vain; where it moves otherwise. What moves by the part of the tenth lives.
constexpr double feed_change_first = 0.14;
constexpr double feed_change_again = 0.03;
// The first where the power only flickers: the force has risen by less than a tenth then.
constexpr double flicker_change_first = 0.118;
constexpr double feed_change_clear = 0.35;
constexpr double feed_change = 0.1;
constexpr int trials_max = 3;

// Of the power that the change of the feed demands: an answer. Of the one that is needed to judge:
// a power that lives of itself.
constexpr double answered_part = 0.5;
constexpr double moved_part = 0.35;
// Where it answers already by so little it lives; ln.
constexpr double answer_least = 0.01;

// The change needed in noise, over its standard deviation: of a value that comes every 50 ms the
// smoothing leaves 0.4, and moved_part of the change is then twice what two such values differ by.
constexpr double noise_factor = 3.2;
constexpr double step_of_noise = 0.954;  // median step between two values, in standard deviations

// A living sensor shows the change of a chip within a part of a revolution and few of its lags.
constexpr double revolutions = 0.5;
constexpr double lags = 3.0;
// How much longer a trial lasts than a power takes that falls as fast as the feed has risen.
constexpr double fall_reserve = 3.0;
// A power that moves more slowly than that part of what the feed did drifts.
constexpr double rate_part = 1.0 / 3.0;
constexpr double drift_max_per_s = 0.03;
constexpr double trial_max_s = 20.0;

// The feed has left where it was; below that slowness in falling the reference goes with it.
constexpr double feed_left = 0.01;
constexpr double feed_slides = 0.02;
constexpr double feed_fell = 0.03;
constexpr double slow_s = 0.05;
constexpr double feed_rests = 0.001;
// A change within this time is not made up for by the cut by chance.
constexpr double quick_s = 0.15;

// Of the idle power: less is drawn by no spindle at speed, however warm its bearings are.
constexpr double idle_least_part = 0.7;
// The engagement as the cut began follows what becomes heavier over this time.
constexpr double engagement_s = 0.5;
constexpr double smoothings_to_settle = 3.0;

constexpr double least = 1e-9;

double log_ratio(double value, double to) RT_SAFE {
  return std::log(std::max(value, least) / std::max(to, least));
}

}  // namespace

PowerTrust PowerWatch::look(const Inputs& inputs) RT_SAFE {
  if (!std::isfinite(inputs.power_w)) return PowerTrust::lost;
  count_.learn(inputs.power_w);
  if (is_below_idle(inputs)) return PowerTrust::stuck;
  if (!inputs.cuts) {
    cutting_s_ = 0.0;
    engagement_ = 0.0;
    trial_ = {};
    trials_ = 0;
    return PowerTrust::good;
  }
  follow(inputs);
  if (is_too_light(inputs)) return PowerTrust::stuck;
  if (!count_.is_within_flicker(inputs.power_w, steady_w_)) {
    steady_w_ = inputs.power_w;
    steady_ = {.feed = inputs.feed_per_rev};
  }
  steady_.s += inputs.cycle_s;
  const bool is_alive = !only_flickers(inputs) && lives();
  if (is_alive || falls_slowly(inputs)) {
    if (is_alive) trials_ = 0;
    refer(inputs);
    chain_ = {.feed = inputs.feed_per_rev};
    trial_ = {};
    return PowerTrust::good;
  }
  if (std::abs(log_ratio(inputs.feed_per_rev, chain_.feed)) > feed_left) chain_.s += inputs.cycle_s;
  if (std::abs(log_ratio(inputs.feed_per_rev, reference_.feed)) > feed_left)
    reference_.left_s += inputs.cycle_s;
  else
    reference_.left_s = 0.0;
  if (!is_unanswered(inputs)) {
    trial_ = {};
    return PowerTrust::good;
  }
  if (!trial_.is_on) begin_trial(inputs);
  return go_on_with_trial(inputs);
}

bool PowerWatch::is_below_idle(const Inputs& inputs) RT_SAFE {
  const double lacking_w = idle_least_part * inputs.power_idle_w - inputs.power_w;
  const bool is_below =
      inputs.is_at_speed && lacking_w > SensorCount::flicker_counts * count_.count_w();
  below_idle_s_ = is_below ? below_idle_s_ + inputs.cycle_s : 0.0;
  return below_idle_s_ > lags * config_.power_lag_s + config_.power_answer_s;
}

bool PowerWatch::is_too_light(const Inputs& inputs) RT_SAFE {
  const double settling_s = inputs.revolution_s + lags * config_.power_lag_s +
                            smoothings_to_settle * SmoothedCut::smoothing_s;
  if (config_.lighter_max <= 0.0 || cutting_s_ < settling_s) return false;
  const double now = cut_.power_w() / std::max(cut_.demand(), least);
  if (engagement_ == 0.0) engagement_ = now;
  if (now > engagement_)
    engagement_ += (now - engagement_) * (1.0 - std::exp(-inputs.cycle_s / engagement_s));
  return now < (1.0 - config_.lighter_max) * engagement_;
}

void PowerWatch::follow(const Inputs& inputs) RT_SAFE {
  const double cut_w = inputs.power_w - inputs.power_idle_w;
  const double demand =
      inputs.speed_radius * std::pow(std::max(inputs.feed_per_rev, least), config_.feed_exponent);
  if (cutting_s_ == 0.0) {
    cut_.begin(demand, cut_w);
    steady_w_ = inputs.power_w;
    steady_ = chain_ = {.feed = inputs.feed_per_rev};
    refer(inputs);
  }
  cutting_s_ += inputs.cycle_s;
  cut_.follow(
      demand, cut_w,
      {.cycle_s = inputs.cycle_s, .chip_s = inputs.revolution_s, .sensor_s = config_.power_lag_s});
}

void PowerWatch::refer(const Inputs& inputs) RT_SAFE {
  reference_ = {.feed = inputs.feed_per_rev, .smooth_w = cut_.power_w(), .demand = cut_.demand()};
}

// ln of the power that stands out of noise and flicker.
double PowerWatch::change_in_noise() const RT_SAFE {
  const double change_w = std::max(noise_factor * count_.usual_step_w() / step_of_noise,
                                   SensorCount::flicker_counts * count_.count_w() / moved_part);
  return change_w / std::max(cut_.power_w(), least);
}

// That of a whole tenth of feed also when less is judged.
double PowerWatch::change_of_life() const RT_SAFE {
  return std::max(config_.feed_exponent * std::log1p(feed_change), change_in_noise());
}

// By an answer to the feed, or of itself.
bool PowerWatch::lives() const RT_SAFE {
  const double moved = log_ratio(cut_.power_w(), reference_.smooth_w);
  if (count_.is_within_flicker(cut_.power_w(), reference_.smooth_w)) return false;
  const double demanded = log_ratio(cut_.demand(), reference_.demand);
  const double per_s = std::min(rate_part * rate_per_s_, drift_max_per_s);
  const double quickly = trial_.is_on ? per_s * trial_.time_s : 0.0;
  const double life = std::max(moved_part * change_of_life(), quickly);
  if (std::abs(moved) >= life) return true;
  if (trial_.is_on && log_ratio(trial_.most_w, trial_.least_w) >= life) return true;
  const bool is_clear = std::abs(demanded) >= std::max(answer_least, change_in_noise());
  return is_clear && moved / demanded >= answered_part;
}

// The controller follows a cut that becomes heavier: the power stays, and the feed is none too
// high.
bool PowerWatch::falls_slowly(const Inputs& inputs) const RT_SAFE {
  const double part = inputs.feed_per_rev / std::max(reference_.feed, least);
  return part < 1.0 - feed_slides && part > 1.0 - feed_fell && reference_.left_s >= slow_s;
}

double PowerWatch::change_judged() const RT_SAFE {
  const double change = trials_ == 0 ? feed_change_first : feed_change_again;
  return std::max(config_.feed_exponent * std::log1p(change), change_in_noise());
}

// Seen at once; a power that moves otherwise is judged when the sensor must show the feed. Once it
// was tried, a change that would leave the flicker is enough.
bool PowerWatch::only_flickers(const Inputs& inputs) const RT_SAFE {
  constexpr double reserve = 1.2;
  const double flicker =
      reserve * SensorCount::flicker_counts * count_.count_w() / std::max(cut_.power_w(), least);
  const double first = config_.feed_exponent * std::log1p(flicker_change_first);
  const double again = config_.feed_exponent * std::log1p(feed_change_again);
  const double judged =
      trials_ == 0 ? std::max(first, change_in_noise()) : std::max(again, flicker);
  const double change = config_.feed_exponent * log_ratio(inputs.feed_per_rev, steady_.feed);
  return std::abs(change) > judged;
}

// After a trial in vain what the sensor may still show is not waited for. Before it the demand must
// be clear: a power that still falls with a step of the cut has that to make up for.
bool PowerWatch::is_unanswered(const Inputs& inputs) const RT_SAFE {
  if (only_flickers(inputs)) return true;
  if (trials_ > 0) {
    const double rise = config_.feed_exponent * log_ratio(inputs.feed_per_rev, reference_.feed);
    return rise > change_judged();
  }
  const double clear = config_.feed_exponent * std::log1p(feed_change_clear);
  return std::abs(log_ratio(cut_.demand(), reference_.demand)) >=
         std::max(clear, change_in_noise());
}

void PowerWatch::begin_trial(const Inputs& inputs) RT_SAFE {
  const double patience_s =
      revolutions * inputs.revolution_s + lags * config_.power_lag_s + config_.power_answer_s;
  rate_per_s_ = rise_per_s(inputs);
  if (only_flickers(inputs)) {
    reference_.smooth_w = inputs.power_w - inputs.power_idle_w;
    cut_.take_power(reference_.smooth_w);
  }
  const double falls_s = fall_reserve * moved_part * change_of_life() / rate_per_s_;
  const double lag_s = inputs.revolution_s + SmoothedCut::smoothing_s;
  trial_ = {.is_on = true,
            .due_s = lag_s + std::clamp(falls_s, patience_s, trial_max_s),
            .feed_least = inputs.feed_per_rev,
            .least_w = cut_.power_w(),
            .most_w = cut_.power_w()};
}

// Of the ln of what the feed demands, since the power lived or since it only flickers.
double PowerWatch::rise_per_s(const Inputs& inputs) const RT_SAFE {
  const bool flickers = only_flickers(inputs);
  const double since = flickers ? steady_.feed : reference_.feed;
  const double time_s = flickers ? steady_.s : reference_.left_s;
  const auto per_s = [&](double feed, double seconds) RT_SAFE {
    const double change = config_.feed_exponent * std::abs(log_ratio(inputs.feed_per_rev, feed));
    return std::max(change, least) / (seconds + inputs.cycle_s);
  };
  return std::min(per_s(since, time_s), per_s(chain_.feed, chain_.s));
}

// In trials: one, or more where no cut makes up for the change by chance.
double PowerWatch::weight(const Inputs& inputs) const RT_SAFE {
  const double since = inputs.is_at_minimum ? steady_.feed : reference_.feed;
  const bool is_clear = inputs.is_at_minimum || reference_.left_s <= quick_s;
  return is_clear ? std::abs(log_ratio(inputs.feed_per_rev, since)) / std::log1p(feed_change) : 1.0;
}

// A feed that falls on is not at rest, and the trial begins anew.
PowerTrust PowerWatch::go_on_with_trial(const Inputs& inputs) RT_SAFE {
  trial_.time_s += inputs.cycle_s;
  trial_.weight = std::max(trial_.weight, weight(inputs));
  trial_.least_w = std::min(trial_.least_w, cut_.power_w());
  trial_.most_w = std::max(trial_.most_w, cut_.power_w());
  if (inputs.feed_per_rev < (1.0 - feed_rests) * trial_.feed_least) {
    trial_.feed_least = inputs.feed_per_rev;
    trial_.time_s = 0.0;
  }
  if (trial_.time_s < trial_.due_s) return PowerTrust::good;
  const bool is_clear =
      trial_.weight >= trials_max && (inputs.is_at_minimum || only_flickers(inputs));
  // One that stayed there while the feed stood is frozen: a cut that becomes lighter would show.
  constexpr double frozen_counts = 2.0;
  const bool is_frozen = trial_.most_w - trial_.least_w <= frozen_counts * count_.count_w();
  const bool only_flickered = (trials_ > 0 || is_frozen) && only_flickers(inputs);
  ++trials_;
  if (trials_ >= trials_max || is_clear || only_flickered) return PowerTrust::stuck;
  refer(inputs);
  steady_.feed = inputs.feed_per_rev;
  trial_ = {};
  return PowerTrust::good;
}

}  // namespace stanok::process
