// A circle, followed by two simulated servo axes under position controllers: interpolator,
// controller and drive, cycle by cycle. For tests and for the figures of docs/developer/motion.md.
//
// At every cycle instant the positions are measured in whole increments, the controllers ask for
// their velocities, and the drives move for one cycle.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/path/axis_codes.h"
#include "motion/threads/position_controller.h"
#include "plant/mechanics/servo_axis.h"
#include "tests/motion/path_samples.h"

namespace stanok::testing {

struct CircleTask {
  double radius = 20.0;       // mm
  double feed_per_s = 100.0;  // mm/s
  double resolution = 0.001;  // mm per increment
  plant::VelocityLoopConfig loop{};
};

// Where the controller has V, a and J from.
enum class RateSource { interpolator, differences };

// One cycle on the steady part of the circle; X and Y in mm.
struct FollowedCycle {
  std::array<double, 2> error{};   // setpoint less position of the load at the end of the cycle
  std::array<double, 2> demand{};  // U in mm/s during the cycle
};

inline constexpr double circle_cycle_s = 0.001;

// The gains that invert the drive: its transfer function from U to the position of the load is
// 1 / (s + ka s^2 + kr s^3 + ...).
inline motion::ControllerGains inverting_gains(double kp, const plant::VelocityLoopConfig& loop) {
  const double w = 2.0 * std::numbers::pi * loop.bandwidth_hz;
  const double r = 2.0 * std::numbers::pi * loop.resonance_hz;
  return {.kp = kp, .kv = 1.0, .ka = 2.0 * loop.damping / w, .kr = 1.0 / (w * w) + 1.0 / (r * r)};
}

// Some turns as the interpolator gives them, from rest to rest.
inline std::vector<motion::testing::Sample> circle_samples(const CircleTask& task) {
  constexpr double turns = 4.0;
  const motion::testing::Limits limits{.v = 400.0, .a = 2e4, .j = 1e6};
  motion::testing::ChainMaker chain(limits);
  chain.arc(task.radius, turns * 2.0 * std::numbers::pi, task.feed_per_s).end_chain();
  return motion::testing::run_path(motion::testing::three_axes(limits, circle_cycle_s),
                                   chain.built());
}

// One axis of it under its controller.
class FollowingAxis {
 public:
  FollowingAxis(const CircleTask& task, const motion::ControllerGains& gains, RateSource source,
                double start)
      : source_(source),
        scale_{.resolution = task.resolution},
        controller_(gains, 1000.0),
        differences_(position_code(start, scale_), task.resolution, circle_cycle_s),
        drive_(task.loop, {}, start) {}

  // The cycle from `now` to `next`; returns U.
  double advance(const kinematics::Jet& now, const kinematics::Jet& next) {
    const auto measured = position_code(drive_.motion().position, scale_);
    const auto behind = static_cast<double>(position_code(now.value, scale_) - measured);
    const motion::SetpointRates differenced =
        differences_.advance(position_code(next.value, scale_));
    const motion::SetpointRates coming = source_ == RateSource::differences
                                             ? differenced
                                             : motion::coming_rates(now, circle_cycle_s);
    const double demand = controller_.demand(behind * scale_.resolution, coming);
    drive_.follow({.position = next.value, .velocity = demand}, circle_cycle_s);
    return demand;
  }
  [[nodiscard]] double position() const { return drive_.motion().position; }

 private:
  RateSource source_;
  motion::CodeScale scale_;
  motion::PositionController controller_;
  motion::CodeDifferences differences_;
  plant::ServoAxis drive_;
};

// The cycles at full feed, half a second after it was reached.
inline std::vector<FollowedCycle> follow_circle(const CircleTask& task,
                                                const motion::ControllerGains& gains,
                                                RateSource source) {
  constexpr int settling_cycles = 500;
  const auto samples = circle_samples(task);
  std::vector<FollowedCycle> steady;
  std::array<FollowingAxis, 2> axes{
      FollowingAxis(task, gains, source, samples[0].out.axes[0].value),
      FollowingAxis(task, gains, source, samples[0].out.axes[1].value)};
  int at_feed = 0;
  for (std::size_t n = 0; n + 1 < samples.size(); ++n) {
    FollowedCycle cycle;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const kinematics::Jet& next = samples[n + 1].out.axes[k];
      cycle.demand[k] = axes[k].advance(samples[n].out.axes[k], next);
      cycle.error[k] = next.value - axes[k].position();
    }
    at_feed = samples[n + 1].out.s_speed == task.feed_per_s ? at_feed + 1 : 0;
    if (at_feed > settling_cycles) steady.push_back(cycle);
  }
  return steady;
}

// Root of the mean square of both axes together.
inline double following_error_rms(const std::vector<FollowedCycle>& cycles) {
  double sum = 0.0;
  for (const FollowedCycle& cycle : cycles)
    sum += cycle.error[0] * cycle.error[0] + cycle.error[1] * cycle.error[1];
  return std::sqrt(sum / static_cast<double>(cycles.size()));
}

// Rms of the second difference of U over one axis, in mm/s: what of U changes from cycle to cycle
// and no motor can follow.
inline double roughness(const std::vector<FollowedCycle>& cycles) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t n = 2; n < cycles.size(); ++n) {
    for (std::size_t k = 0; k < 2; ++k) {
      const double second =
          cycles[n].demand[k] - 2.0 * cycles[n - 1].demand[k] + cycles[n - 2].demand[k];
      sum += second * second;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

}  // namespace stanok::testing
