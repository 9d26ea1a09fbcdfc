// Threads in the cycle: what the encoders of the spindles say, and what taps ask of the spindles.
//
// The measured angle is that of the drive where the spindle is an axis with a drive that answers;
// else that of the commanded spindle, in whole counts of its encoder. Both belong to the instant at
// which the cycle begins; the set-points, to its end.
#include <cmath>

#include "channels/axes/spindle.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

constexpr int counts_per_pulse = 4;  // both edges of both tracks

// A position that a bus brings more seldom than once a cycle stays the same between. It counts as
// told again when the spindle does not turn so far in a cycle, or after so long.
constexpr double unseen_turns = 1.0 / 2000;
constexpr double unseen_s = 0.05;

double in_counts(double angle_deg, int pulses) RT_SAFE {
  const double count_deg = full_turn_deg / (counts_per_pulse * pulses);
  return count_deg * std::round(angle_deg / count_deg);
}

// As it is commanded to turn.
motion::SpindleMotion command_of(const Spindle& spindle) RT_SAFE {
  return {.turns = spindle.turns(),
          .speed = spindle.speed() / seconds_per_minute,
          .speed_wanted = spindle.target() / seconds_per_minute};
}

}  // namespace

void Channel::observe_spindles() RT_SAFE {
  for (int s = 0; s < figures_.spindle_count; ++s) {
    const auto i = static_cast<std::size_t>(s);
    motion::SpindleObserver& observer = observers_[i];
    const motion::SpindleMotion now = command_of(spindles_[i]);
    observer.advance(figures_.cycle_s, now);
    if (const auto angle_deg = measured_angle(i)) observer.observe(*angle_deg);
    Spindle spindle = spindles_[i];
    spindle.advance(figures_.cycle_s);
    motion::SpindleMotion next = command_of(spindle);
    next.acceleration = (next.speed - now.speed) / figures_.cycle_s;
    interpolator_.see_spindle(i, observer.ahead(figures_.cycle_s, next));
  }
}

// Nothing: no news in this cycle.
std::optional<double> Channel::measured_angle(std::size_t spindle) RT_SAFE {
  const SpindleConfig& config = figures_.spindles[spindle];
  const int axis = figures_.spindle_axis[spindle];
  const auto k = static_cast<std::size_t>(axis);
  if (axis < 0 || drives_are_ideal_) {
    const double angle = axis < 0 ? spindles_[spindle].angle_deg() : setpoints_[k].position;
    return config.encoder_pulses > 0 ? in_counts(angle, config.encoder_pulses) : angle;
  }
  if (!feedback_[k].valid) return std::nullopt;
  EncoderNews& news = encoder_news_[spindle];
  const bool is_same = feedback_[k].position == news.angle_deg;
  const double turns = std::abs(observers_[spindle].now().speed) * figures_.cycle_s;
  if (is_same && turns > unseen_turns && news.age_s < unseen_s) {
    news.age_s += figures_.cycle_s;
    return std::nullopt;
  }
  news = {feedback_[k].position, 0.0};
  return news.angle_deg;
}

// After the interpolation, before the spindles go on.
void Channel::follow_thread() RT_SAFE {
  const motion::SpindleOrder& order = path_.spindle_order;
  Spindle& spindle = spindles_[static_cast<std::size_t>(order.spindle)];
  switch (order.kind) {
    case motion::SpindleOrder::Kind::none:
      break;
    case motion::SpindleOrder::Kind::stop_within:
      spindle.stop_within(order.turns);
      break;
    case motion::SpindleOrder::Kind::turn_back:
      spindle.turn_back(order.factor, seconds_per_minute * order.acceleration);
      break;
    case motion::SpindleOrder::Kind::go_on:
      spindle.go_on();
      wait(Activity::spindle, 0.0);
      break;
  }
  if (path_.has_lost_spindle && !resetting_)
    fail_run("A4001", "the axes cannot follow the spindle through the thread", path_.tag);
}

}  // namespace stanok::channels
