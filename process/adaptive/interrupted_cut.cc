#include "process/adaptive/interrupted_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::process {
namespace {

using std::numbers::pi;

// Of the mean: a line that begins to count, and one that counts no longer. The first is that of a
// gap of an eighth of a turn, a multiple of what noise or a sensor far behind makes of a full cut.
constexpr double swing_counts = 0.3;
constexpr double swing_ends = 0.2;
// A mean that moves by more of the line is that of a cut that changes.
constexpr double drift_part = 0.5;
// Lines of two turns are alike when they point the same way, within 45 degrees.
constexpr double alike_cosine = 0.7;
// Turns over which the line is smoothed.
constexpr int turns_smoothed = 4;

// Further behind, a line is lost in the lag of the sensor.
constexpr double lag_angle_max = 4.0;  // rad
constexpr double polls_per_line = 2.5;
// A mean below that of the smallest power is no cut.
constexpr double mean_least_w = 1e-6;

double sinc(double x) RT_SAFE {
  return x == 0.0 ? 1.0 : std::sin(pi * x) / (pi * x);
}

// The part d of a turn with 2 sinc(d) = swing.
double duty_of(double swing) RT_SAFE {
  constexpr double duty_min = 0.05;
  constexpr int halvings = 30;
  double low = duty_min;
  double high = 1.0;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (2.0 * sinc(middle) > swing ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

void InterruptedCut::follow(const Inputs& inputs) RT_SAFE {
  if (!inputs.feeds || inputs.turns_per_s <= 0.0 || !std::isfinite(inputs.cutting_w)) {
    turn_ = {};
    angle_ = 0.0;
    turns_alike_ = 0;
    return;
  }
  watch_polls(inputs);
  add_up(inputs.cutting_w);
  angle_ += inputs.turns_per_s * inputs.cycle_s;
  if (angle_ < 1.0) return;
  angle_ = std::fmod(angle_, 1.0);
  end_turn(1.0 / inputs.turns_per_s);
  turn_ = {};
}

// What a sensor shows between two polls is as old as half a poll: not its lag, and no weaker.
void InterruptedCut::watch_polls(const Inputs& inputs) RT_SAFE {
  constexpr double learning = 0.05;
  constexpr double missed = 1.8;  // polls without another value
  unchanged_s_ += inputs.cycle_s;
  if (inputs.cutting_w == power_seen_w_) return;
  power_seen_w_ = inputs.cutting_w;
  if (poll_s_ == 0.0) {
    poll_s_ = unchanged_s_ < config_.power_lag_s ? unchanged_s_ : 0.0;
  } else if (unchanged_s_ < missed * poll_s_) {
    poll_s_ += learning * (unchanged_s_ - poll_s_);
  }
  unchanged_s_ = 0.0;
}

void InterruptedCut::add_up(double cutting_w) RT_SAFE {
  const double first_cosine = std::cos(2.0 * pi * angle_);
  const double first_sine = std::sin(2.0 * pi * angle_);
  double cosine = first_cosine;
  double sine = first_sine;
  turn_.power += cutting_w;
  for (std::size_t k = 0; k < orders; ++k) {
    turn_.power_times[k].cosine += cutting_w * cosine;
    turn_.power_times[k].sine += cutting_w * sine;
    turn_.angle[k].cosine += cosine;
    turn_.angle[k].sine += sine;
    const double next = cosine * first_cosine - sine * first_sine;
    sine = sine * first_cosine + cosine * first_sine;
    cosine = next;
  }
  ++turn_.cycles;
}

// Over the mean; exactly nothing for a power that stays, whatever part of a cycle the turn ends in.
InterruptedCut::Line InterruptedCut::line_of_turn(int order, double mean_w) const RT_SAFE {
  const auto k = static_cast<std::size_t>(order - 1);
  const double scale = 2.0 / (static_cast<double>(turn_.cycles) * mean_w);
  return {scale * (turn_.power_times[k].cosine - mean_w * turn_.angle[k].cosine),
          scale * (turn_.power_times[k].sine - mean_w * turn_.angle[k].sine)};
}

// The factor that lag and polls have taken from a line; 0: too much of it.
double InterruptedCut::given_back(int order, double turn_s) const RT_SAFE {
  const double frequency_hz = order / turn_s;
  const double lag_s = std::max(0.0, config_.power_lag_s - 0.5 * poll_s_);
  const double lag_angle = 2.0 * pi * frequency_hz * lag_s;
  if (lag_angle > lag_angle_max || polls_per_line * frequency_hz * poll_s_ > 1.0) return 0.0;
  return std::sqrt(1.0 + lag_angle * lag_angle) / sinc(frequency_hz * poll_s_);
}

int InterruptedCut::strongest_order(double mean_w, double turn_s) const RT_SAFE {
  if (config_.gaps_per_turn > 0) return std::min(config_.gaps_per_turn, orders);
  int strongest = 1;
  double most = 0.0;
  for (int order = 1; order <= orders; ++order) {
    const Line line = line_of_turn(order, mean_w);
    const double swing = given_back(order, turn_s) * std::hypot(line.cosine, line.sine);
    if (swing <= most) continue;
    most = swing;
    strongest = order;
  }
  return strongest;
}

void InterruptedCut::end_turn(double turn_s) RT_SAFE {
  const double mean_before_w = mean_w_;
  mean_w_ = turn_.power / static_cast<double>(turn_.cycles);
  if (mean_w_ < mean_least_w) {
    turns_alike_ = 0;
    return;
  }
  const int order = strongest_order(mean_w_, turn_s);
  const double back = given_back(order, turn_s);
  const Line line = line_of_turn(order, mean_w_);
  const double length = std::hypot(line.cosine, line.sine);
  const double swing = back * length;
  const bool counts = swing > (is_interrupted() ? swing_ends : swing_counts);
  const bool stays =
      is_interrupted() || std::abs(mean_w_ - mean_before_w) * back < drift_part * swing * mean_w_;
  if (!counts || !stays) {
    turns_alike_ = 0;
    order_ = order;
    line_ = line;
    return;
  }
  const double along = line.cosine * line_.cosine + line.sine * line_.sine;
  const bool is_alike =
      order == order_ && along > alike_cosine * length * std::hypot(line_.cosine, line_.sine);
  turns_alike_ = is_alike ? std::min(turns_alike_ + 1, turns_smoothed) : 1;
  order_ = order;
  line_.cosine += (line.cosine - line_.cosine) / turns_alike_;
  line_.sine += (line.sine - line_.sine) / turns_alike_;
  duty_ = duty_of(back * std::hypot(line_.cosine, line_.sine));
}

}  // namespace stanok::process
