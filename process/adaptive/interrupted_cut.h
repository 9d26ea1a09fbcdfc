// InterruptedCut: the height of a force that comes and goes with every turn of the spindle.
//
// A workpiece with g gaps around it is cut for a part d of each g-th of a turn. The mean of its
// power over a turn is d times the power in the cut, and its line at g times the spindle's
// frequency is 2 sin(pi d) / (pi d) times the mean: from both follow d and the power in the cut,
// which the tool feels. The line is found against the angle of the spindle, as a mean over some
// turns, so that noise and what does not belong to the turn stay outside; what lag and polls of the
// sensor take from it is given back. Where g is not given it is the order of the strongest line. A
// cut counts as interrupted when two turns in a row show the same line at the same angle, with a
// mean that stays; else nothing of it is in the feed.
//
// Part of the force control of a channel, in the cycle; allocates nothing.
#pragma once

#include <array>
#include <cstdint>

#include "base/rt_safe.h"
#include "process/adaptive/force_control_config.h"

namespace stanok::process {

class InterruptedCut {
 public:
  explicit InterruptedCut(const ForceControlConfig& config) : config_(config) {}

  struct Inputs {
    double cycle_s = 0.001;
    double turns_per_s = 0.0;
    double cutting_w = 0.0;  // N_d - N_x
    bool feeds = false;      // the path goes at working feed
  };
  // Once a cycle.
  void follow(const Inputs& inputs) RT_SAFE;

  [[nodiscard]] bool is_interrupted() const RT_SAFE { return turns_alike_ >= turns_needed; }
  // Of the last whole turn: the power while the tool cuts, its mean over the turn, and their ratio.
  [[nodiscard]] double peak_w() const RT_SAFE { return mean_w_ / duty_; }
  [[nodiscard]] double mean_w() const RT_SAFE { return mean_w_; }
  [[nodiscard]] double duty() const RT_SAFE { return duty_; }
  [[nodiscard]] int order() const RT_SAFE { return order_; }  // g

 private:
  static constexpr int orders = 8;
  static constexpr int turns_needed = 2;

  struct Line {
    double cosine = 0.0;
    double sine = 0.0;
  };
  // What one turn adds up to.
  struct Turn {
    double power = 0.0;
    std::array<Line, orders> power_times{};  // cosine and sine of each order
    std::array<Line, orders> angle{};        // the same without the power
    std::int64_t cycles = 0;
  };

  void add_up(double cutting_w) RT_SAFE;
  void watch_polls(const Inputs& inputs) RT_SAFE;
  void end_turn(double turn_s) RT_SAFE;
  [[nodiscard]] Line line_of_turn(int order, double mean_w) const RT_SAFE;
  [[nodiscard]] double given_back(int order, double turn_s) const RT_SAFE;
  [[nodiscard]] int strongest_order(double mean_w, double turn_s) const RT_SAFE;

  ForceControlConfig config_;
  double angle_ = 0.0;  // of the spindle since the turn began, in turns
  Turn turn_;
  double mean_w_ = 0.0;
  Line line_;  // over the mean, smoothed over turns
  int order_ = 0;
  int turns_alike_ = 0;
  double duty_ = 1.0;
  double power_seen_w_ = 0.0;
  double unchanged_s_ = 0.0;  // since the sensor gave another value
  double poll_s_ = 0.0;       // how often it does
};

}  // namespace stanok::process
