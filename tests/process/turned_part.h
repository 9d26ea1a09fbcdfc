// TurnedPart: a lathe in small, for closed loops with a control that knows nothing of it.
//
// The surface behind the tool is kept angle by angle: h is what the tool went on since the angle
// was cut last, so that entry, gaps, steps and the delay of a turn come from geometry and not from
// the formula of the control or of plant/cutting. F = C t h^0.75 (HB/200)^0.75 at each angle;
// spindle drive and sensor follow the power with a lag, the bus brings it every few ms in whole
// watts. Steps of a tenth of a millisecond.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "process/adaptive/force_control.h"

namespace stanok::testing {

struct TurnedScene {
  double rev_per_min = 600.0;
  double feed_programmed = 2.0;  // mm/s
  double radius_mm = 30.0;
  double lag_s = 0.02;
  int poll_ms = 10;
  double idle_w = 250.0;
  double efficiency = 0.85;
  double noise = 0.0;        // of the cutting power, standard deviation of a polled value
  double approach_mm = 2.0;  // in front of the face
};

class TurnedPart {
 public:
  TurnedPart(const process::ForceControlConfig& config, const TurnedScene& scene)
      : control(config), scene_(scene), cut_at_mm_(angles, 0.0), z_mm_(-scene.approach_mm) {
    cut_.rev_per_min = scene.rev_per_min;
    cut_.at_speed = true;
    cut_.spindle_starts = 1;
    cut_.frame_is_new = true;
    cut_.radius_mm = scene.radius_mm;
    cut_.power_w = scene.idle_w;
    cut_.vibration_um = cut_.vibration_hz = 0.0;
  }

  // Depth at a place along the axis and around it (0 to 1); 0: a gap. Hardness at a place.
  std::function<double(double, double)> depth_mm = [](double, double) { return 2.0; };
  std::function<double(double)> hardness_hb = [](double) { return 200.0; };
  // What the sensor makes of the power; none: whole watts.
  std::function<double(double)> sensor;

  void begin(double force_n, double feed_max = 600.0) {
    static_cast<void>(control.command({.kind = motion::ForceCommand::Kind::force,
                                       .force_n = force_n,
                                       .feed_min = 10.0,
                                       .feed_max = feed_max}));
    for (int k = 0; k < 3000 && !control.is_ready(); ++k) cycle();
    cut_.is_controllable = true;
    cut_.feed_programmed = scene_.feed_programmed;
  }

  // Until the tool stands there, at most so long; `watch` after each cycle.
  void run_to(double z_mm, double seconds, const std::function<void()>& watch = {}) {
    for (const double end = time_s + seconds; z_mm_ < z_mm && time_s < end;) {
      cycle();
      if (watch) watch();
    }
  }

  void cycle() {
    const motion::FeedDemand demand = control.advance(cut_);
    cut_.frame_is_new = false;
    if (control.event() != motion::ForceEvent::none) events.push_back(control.event());
    feed = 0.0;
    if (cut_.is_controllable)
      feed = demand.feed_per_s > 0.0 ? demand.feed_per_s : cut_.feed_programmed;
    if (control.status().state == motion::ForceState::fault) feed = demand.feed_per_s;
    cut_.path_speed = feed;
    force_least_n = std::numeric_limits<double>::infinity();
    force_most_n = 0.0;
    for (int k = 0; k < steps_per_cycle; ++k) step(cut_.cycle_s / steps_per_cycle);
    ++cycles_;
    time_s += cut_.cycle_s;
    if (cycles_ % scene_.poll_ms != 0) return;
    const double noisy_w = power_w_ * (1.0 + scene_.noise * gauss_(random_));
    const double shown_w = scene_.idle_w + noisy_w;
    cut_.power_w = sensor ? sensor(shown_w) : std::round(shown_w);
  }

  [[nodiscard]] double z_mm() const { return z_mm_; }
  [[nodiscard]] double cutting_power_w() const { return power_w_; }
  [[nodiscard]] bool is_fault() const {
    return control.status().state == motion::ForceState::fault;
  }
  [[nodiscard]] bool told(motion::ForceEvent event) const {
    return std::ranges::find(events, event) != events.end();
  }

  process::ForceControl control;
  std::vector<motion::ForceEvent> events;
  double time_s = 0.0;
  double feed = 0.0;
  double force_n = 0.0;       // now
  double force_most_n = 0.0;  // in the latest cycle
  double force_least_n = 0.0;

 private:
  static constexpr int angles = 720;
  static constexpr int steps_per_cycle = 10;

  void step(double dt) {
    z_mm_ += feed * dt;
    const double turns = scene_.rev_per_min / 60.0 * dt;
    const int from = static_cast<int>(std::floor(angle_ * angles));
    angle_ += turns;
    const int to = static_cast<int>(std::floor(angle_ * angles));
    for (int k = from; k < to; ++k) cut(k % angles);
    if (angle_ >= 1.0) angle_ -= 1.0;
    force_most_n = std::max(force_most_n, force_n);
    force_least_n = std::min(force_least_n, force_n);
    const double omega = 2.0 * std::numbers::pi * scene_.rev_per_min / 60.0;
    const double wanted_w = force_n * omega * scene_.radius_mm * 1e-3 / scene_.efficiency;
    power_w_ += (wanted_w - power_w_) * (1.0 - std::exp(-dt / scene_.lag_s));
  }
  void cut(int k) {
    double& cut_at = cut_at_mm_[static_cast<std::size_t>(k)];
    const double depth = z_mm_ > 0.0 ? depth_mm(z_mm_, (k + 0.5) / angles) : 0.0;
    const double h = std::max(0.0, z_mm_ - cut_at);
    cut_at = std::max(cut_at, z_mm_);
    force_n = depth > 0.0
                  ? 1600.0 * depth * std::pow(h, 0.75) * std::pow(hardness_hb(z_mm_) / 200.0, 0.75)
                  : 0.0;
  }

  TurnedScene scene_;
  motion::CutState cut_;
  std::vector<double> cut_at_mm_;  // where each angle was cut last
  double z_mm_;
  double angle_ = 0.0;  // of the spindle, 0 to 1
  double power_w_ = 0.0;
  std::int64_t cycles_ = 0;
  std::mt19937 random_{7};
  std::normal_distribution<double> gauss_;
};

}  // namespace stanok::testing
