// CutBench: force control on a cut without a machine; the feed follows at once, the power comes as
// a bus would bring it, sampled, held and in whole watts.
//
// The force is worked out here from the definition of the plant, P = 1600 N t h^0.75 (HB/200)^0.75,
// with h the way over the last revolution from plant::ChipThickness.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "plant/cutting/cutting_process.h"
#include "process/adaptive/force_control.h"

namespace stanok::testing {

struct CutScene {
  double rev_per_min = 600.0;
  double feed_programmed = 2.0;  // mm/s
  double radius_mm = 30.0;
  double lag_s = 0.02;     // of the sensor
  double sample_s = 0.01;  // of the bus
  double idle_w = 250.0;   // at `rev_per_min`
  double efficiency = 0.85;
};

class CutBench {
 public:
  explicit CutBench(const process::ForceControlConfig& config, const CutScene& scene = {})
      : control(config), scene_(scene) {
    cut.rev_per_min = scene.rev_per_min;
    cut.at_speed = true;
    cut.spindle_starts = 1;
    cut.frame_is_new = true;
    cut.radius_mm = scene.radius_mm;
    cut.power_w = scene.idle_w;
    cut.vibration_um = 0.0;
    cut.vibration_hz = 0.0;
  }

  // At rest, until the idle power is known.
  void wait_until_ready() {
    for (int k = 0; k < 3000 && !control.is_ready(); ++k) cycle();
  }

  // Working feed from here on.
  void cut_at_feed() {
    cut.is_controllable = true;
    cut.feed_programmed = scene_.feed_programmed;
  }

  void run(double seconds, const std::function<void()>& watch = {}) {
    for (int k = 0; k < static_cast<int>(std::lround(seconds / cut.cycle_s)); ++k) {
      cycle();
      if (watch) watch();
    }
  }

  void cycle() {
    const motion::FeedDemand demand = control.advance(cut);
    cut.frame_is_new = false;
    if (control.event() != motion::ForceEvent::none) events.push_back(control.event());
    time_s += cut.cycle_s;
    feed = 0.0;
    if (cut.is_controllable || cut.is_rapid)
      feed = demand.feed_per_s > 0.0 ? demand.feed_per_s : cut.feed_programmed;
    cut.path_speed = cut.feed_override * feed;
    const double turns = cut.rev_per_min / 60.0 * cut.cycle_s;
    chip_.advance(depth_mm > 0.0 ? cut.path_speed * cut.cycle_s : 0.0, turns);
    force_n = depth_mm > 0.0 ? 1600.0 * depth_mm * std::pow(chip_.thickness_mm(), 0.75) *
                                   std::pow(hardness_hb / 200.0, 0.75)
                             : 0.0;
    const double omega = 2.0 * std::numbers::pi * cut.rev_per_min / 60.0;
    const double cutting_w = force_n * omega * radius_mm() * 1e-3 / scene_.efficiency;
    lagging_w_ += (cutting_w - lagging_w_) * cut.cycle_s / scene_.lag_s;
    since_sample_s_ += cut.cycle_s;
    if (since_sample_s_ < scene_.sample_s) return;
    since_sample_s_ = 0.0;
    if (!sensor_lives) return;
    const double power_w = idle_w() + lagging_w_;
    cut.power_w = sensor ? sensor(power_w) : std::round(power_w);
  }

  [[nodiscard]] double idle_w() const {
    const double r = cut.rev_per_min / scene_.rev_per_min;
    return scene_.idle_w * 0.5 * (r + r * r);
  }
  [[nodiscard]] double radius_mm() const {
    return radius_now_mm > 0 ? radius_now_mm : scene_.radius_mm;
  }
  // Of the mean force over the last `seconds` from now on.
  [[nodiscard]] double mean_error(double seconds) {
    double sum = 0.0;
    int count = 0;
    run(seconds, [&] {
      sum += force_n / control.status().force_set_n - 1.0;
      ++count;
    });
    return sum / count;
  }

  process::ForceControl control;
  motion::CutState cut;
  std::vector<motion::ForceEvent> events;
  double depth_mm = 0.0;
  double hardness_hb = 200.0;
  double radius_now_mm = 0.0;  // 0: as the scene has it
  bool sensor_lives = true;
  std::function<double(double)> sensor;  // what it makes of the power, W; else whole watts
  double time_s = 0.0;
  double feed = 0.0;
  double force_n = 0.0;

 private:
  CutScene scene_;
  plant::ChipThickness chip_;
  double lagging_w_ = 0.0;
  double since_sample_s_ = 0.0;
};

inline motion::ForceCommand force_command(double force_n, double feed_min = 10.0,
                                          double feed_max = 600.0) {
  return {.kind = motion::ForceCommand::Kind::force,
          .force_n = force_n,
          .feed_min = feed_min,
          .feed_max = feed_max};
}

}  // namespace stanok::testing
