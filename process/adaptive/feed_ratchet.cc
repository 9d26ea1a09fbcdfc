#include "process/adaptive/feed_ratchet.h"

#include <algorithm>
#include <cmath>

namespace stanok::process {
namespace {

// Of the rise that the feed demands: an answer.
constexpr double answered_part = 0.5;
// Half a rise over the standard deviation of what the two means differ by.
constexpr double certainty = 4.25;
constexpr int refusals_max = 3;

constexpr double stretch_least_s = 0.16;
constexpr int values_least = 6;

// The feed has left what was measured.
constexpr double feed_left = 0.03;
// Over the confirmed one: less of a rise asks nothing.
constexpr double rise_least = 0.015;
constexpr double risen_part = 0.99;
// The confirmed feed follows one that falls, smoothed, and stays that part above it.
constexpr double above_fallen = 0.005;
constexpr double smoothing_s = 0.3;
constexpr double force_smoothing_s = 0.2;
// Of the setpoint: the feed is to rise, or not any more.
constexpr double too_low = 0.985;
constexpr double reached = 1.0;

constexpr double question_period_s = 60.0;
constexpr double least_part = 0.02;  // of the setpoint, so that its logarithm is finite

}  // namespace

void FeedRatchet::Stretch::add(const Inputs& inputs) RT_SAFE {
  const bool has_changed = time_s_ > 0.0 && inputs.force_n != newest_n_;
  if (has_changed) ++changes_;
  unchanged_s_ = has_changed ? 0.0 : unchanged_s_ + inputs.cycle_s;
  newest_n_ = inputs.force_n;
  force_sum_ += std::max(inputs.force_n, least_part * inputs.wanted_n) * inputs.cycle_s;
  log_feed_sum_ += std::log(inputs.feed) * inputs.cycle_s;
  time_s_ += inputs.cycle_s;
}

double FeedRatchet::Stretch::feed() const RT_SAFE {
  return std::exp(log_feed_sum_ / time_s_);
}

bool FeedRatchet::Stretch::has_values() const RT_SAFE {
  return unchanged_s_ >= stretch_least_s || changes_ >= values_least;
}

void FeedRatchet::leave_cut() RT_SAFE {
  is_in_cut_ = false;
  measured_ = {};
  wants_more_ = false;
  noise_.interrupt();
}

void FeedRatchet::scale(double factor) RT_SAFE {
  confirmed_ *= factor;
  smooth_.feed *= factor;
  before_.reset();
  begin(Phase::before);
}

double FeedRatchet::ceiling() const RT_SAFE {
  switch (phase_) {
    case Phase::rising:
      return (1.0 + config_.feed_step) * confirmed_;
    case Phase::after:
    case Phase::lowered:
      return top_;
    case Phase::before:
    case Phase::again:
      return confirmed_;
  }
  return confirmed_;
}

bool FeedRatchet::look(const Inputs& inputs) RT_SAFE {
  if (!is_in_cut_) {
    is_in_cut_ = true;
    confirmed_ = confirmed_ > 0.0 ? std::min(confirmed_, inputs.feed) : inputs.feed;
    smooth_ = {.feed = inputs.feed, .force_n = inputs.force_n};
    before_.reset();
    since_answer_s_ = 0.0;
    begin(Phase::before);
    waits_s_ = inputs.settling_s;
  }
  follow(inputs);
  if (!inputs.follows) {
    before_.reset();
    begin(Phase::before);
    waits_s_ = inputs.settling_s;
  }
  waits_s_ += phase_ == Phase::rising ? inputs.cycle_s : -inputs.cycle_s;
  if (waits_s_ > 0.0) noise_.interrupt();
  if (phase_ == Phase::rising) rise(inputs);
  if (waits_s_ > 0.0) return true;
  measure(inputs);
  return refusals_ < refusals_max;
}

void FeedRatchet::measure(const Inputs& inputs) RT_SAFE {
  now_.add(inputs);
  const double part = std::max(inputs.force_n / inputs.wanted_n, least_part);
  noise_.add(std::log(part) - config_.feed_exponent * std::log(inputs.feed), inputs.cycle_s);
  switch (phase_) {
    case Phase::before:
      measure_before(inputs);
      break;
    case Phase::after:
      measure_after(inputs);
      break;
    case Phase::again:
      measure_again(inputs);
      break;
    case Phase::lowered:
      measure_lowered(inputs);
      break;
    case Phase::rising:
      break;
  }
}

void FeedRatchet::begin(Phase phase) RT_SAFE {
  phase_ = phase;
  now_ = {};
  waits_s_ = 0.0;
}

void FeedRatchet::follow(const Inputs& inputs) RT_SAFE {
  const auto approach = [&](double& value, double to, double time_s) RT_SAFE {
    value += (to - value) * (time_s > inputs.cycle_s ? inputs.cycle_s / time_s : 1.0);
  };
  approach(smooth_.feed, inputs.feed, smoothing_s);
  approach(smooth_.force_n, inputs.force_n, force_smoothing_s);
  since_answer_s_ += inputs.cycle_s;
  // What was measured before the force fell is of another cut.
  const bool begins_to_want = !wants_more_ && smooth_.force_n < too_low * inputs.wanted_n;
  if (begins_to_want) {
    wants_more_ = true;
    before_.reset();
    if (phase_ == Phase::before) now_ = {};
  } else if (smooth_.force_n >= reached * inputs.wanted_n) {
    wants_more_ = false;
  }
  follow_down();
}

void FeedRatchet::follow_down() RT_SAFE {
  const double lowest = phase_ == Phase::lowered ? top_ : confirmed_;
  if (smooth_.feed >= (1.0 - above_fallen) * lowest) return;
  if (phase_ == Phase::lowered && smooth_.feed >= (1.0 - feed_left) * top_) return;
  confirmed_ = (1.0 + above_fallen) * smooth_.feed;
  if (phase_ != Phase::before) {
    before_.reset();
    begin(Phase::before);
  } else if (now_.time_s() > 0.0 && smooth_.feed < (1.0 - feed_left) * now_.feed()) {
    now_ = {};
  }
  if (before_ && confirmed_ < (1.0 - feed_left) * before_->feed()) before_.reset();
}

bool FeedRatchet::is_long_enough(const Stretch& stretch, double asked, const Inputs& inputs) const
    RT_SAFE {
  if (stretch.time_s() < stretch_least_s || !stretch.has_values()) return false;
  const double half = answered_part * asked;
  if (half * stretch.force_n() < inputs.count_n) return false;
  const double longer = std::sqrt(static_cast<double>(1 << refusals_));
  const auto time_s = noise_.time_within(half / (certainty * longer), inputs.settling_s);
  return time_s && stretch.time_s() >= *time_s;
}

double FeedRatchet::asked(const Stretch& from, const Stretch& to) const RT_SAFE {
  return config_.feed_exponent * std::log(to.feed() / from.feed());
}

// The first measures of a cut are taken soon, by stretches that need not be long enough, each twice
// as long as the one before.
void FeedRatchet::measure_before(const Inputs& inputs) RT_SAFE {
  if (now_.time_s() >= measured_.next_s) {
    measured_.means = {.feed = now_.feed(), .force_n = now_.force_n()};
    measured_.next_s = 2.0 * now_.time_s();
  }
  const double step = config_.feed_exponent * std::log1p(config_.feed_step);
  if (is_long_enough(now_, step, inputs)) {
    before_ = now_;
    measured_.means = {.feed = now_.feed(), .force_n = now_.force_n()};
    now_ = {};
  }
  if (!before_) return;
  if (wants_more_) {
    begin(Phase::rising);
    top_ = confirmed_;
  } else if (config_.asks_downwards && since_answer_s_ > question_period_s) {
    begin(Phase::lowered);
    top_ = confirmed_ / (1.0 + config_.feed_step);
    waits_s_ = inputs.settling_s;
  }
}

bool FeedRatchet::is_up(const Inputs& inputs) const RT_SAFE {
  const double most = std::min((1.0 + config_.feed_step) * confirmed_, inputs.feed_max);
  return inputs.feed >= risen_part * most;
}

void FeedRatchet::rise(const Inputs& inputs) RT_SAFE {
  if (inputs.feed > top_) {
    top_ = inputs.feed;
    waits_s_ = 0.0;
  }
  const bool rests = waits_s_ > inputs.settling_s;
  if (is_up(inputs) || (rests && inputs.feed > (1.0 + rise_least) * confirmed_)) {
    top_ = inputs.feed;
    begin(Phase::after);
    waits_s_ = inputs.settling_s;
  } else if (rests && !wants_more_) {
    begin(Phase::before);
  }
}

void FeedRatchet::measure_after(const Inputs& inputs) RT_SAFE {
  const double rise = asked(*before_, now_);
  if (rise < config_.feed_exponent * std::log1p(rise_least)) {
    before_.reset();
    return begin(Phase::before);
  }
  if (is_long_enough(now_, rise, inputs)) {
    const double answer = std::log(now_.force_n() / before_->force_n());
    if (answer >= answered_part * rise) return confirm(now_);
    after_ = now_;
    begin(Phase::again);
    waits_s_ = inputs.settling_s;
  } else if (wants_more_ && !is_up(inputs)) {
    begin(Phase::rising);
  }
}

// Feed and force of the last stretch are confirmed; the next rise is asked from there.
void FeedRatchet::confirm(const Stretch& at) RT_SAFE {
  confirmed_ = at.feed();
  before_ = at;
  measured_.means = {.feed = at.feed(), .force_n = at.force_n()};
  refusals_ = 0;
  since_answer_s_ = 0.0;
  begin(Phase::before);
}

void FeedRatchet::measure_again(const Inputs& inputs) RT_SAFE {
  const double rise = asked(*before_, after_);
  if (!is_long_enough(now_, rise, inputs)) return;
  const double middle_n = std::sqrt(before_->force_n() * now_.force_n());
  const double change = std::log(now_.force_n() / before_->force_n());
  before_ = now_;
  if (std::log(after_.force_n() / middle_n) >= answered_part * rise) {
    confirmed_ = after_.feed();
    refusals_ = 0;
    since_answer_s_ = 0.0;
    before_.reset();
  } else if (std::abs(change) < answered_part * rise) {
    ++refusals_;
  }
  begin(Phase::before);
}

void FeedRatchet::measure_lowered(const Inputs& inputs) RT_SAFE {
  const double fall = asked(now_, *before_);
  if (!is_long_enough(now_, fall, inputs)) return;
  if (std::log(before_->force_n() / now_.force_n()) >= answered_part * fall) {
    refusals_ = 0;
    since_answer_s_ = 0.0;
  } else {
    ++refusals_;
  }
  before_.reset();
  begin(Phase::before);
}

}  // namespace stanok::process
