// PlantBench: force control on a TurningPlant, without a machine: the feed is what the control asks
// for, at once.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "process/adaptive/force_control.h"
#include "tests/process/plants/turning_plant.h"

namespace stanok::testing {

class PlantBench {
 public:
  PlantBench(const process::ForceControlConfig& config, const TurningScene& scene, unsigned seed)
      : control(config), plant(scene, seed), rev_per_s_(scene.rev_per_min / 60.0) {
    cut_.rev_per_min = scene.rev_per_min;
    cut_.at_speed = true;
    cut_.spindle_starts = 1;
    cut_.frame_is_new = true;
    cut_.radius_mm = scene.radius_mm;
    cut_.power_w = scene.idle_w;
    cut_.vibration_um = cut_.vibration_hz = 0.0;
  }

  // Until the idle power is known; then at working feed, mm/rev.
  void begin(double force_n, double feed_programmed) {
    static_cast<void>(control.command({.kind = motion::ForceCommand::Kind::force,
                                       .force_n = force_n,
                                       .feed_min = 10.0,
                                       .feed_max = 3000.0}));
    for (int k = 0; k < 3000 && !control.is_ready(); ++k) cycle();
    cut_.is_controllable = true;
    cut_.feed_programmed = feed_programmed * rev_per_s_;
  }

  // The depth that the program gives, mm.
  void give_depth(double depth_mm) {
    static_cast<void>(
        control.command({.kind = motion::ForceCommand::Kind::depth, .depth_mm = depth_mm}));
  }

  void run(double seconds, const std::function<void()>& watch = {}) {
    for (int k = 0; k < static_cast<int>(std::lround(seconds / cut_.cycle_s)); ++k) {
      cycle();
      if (watch) watch();
    }
  }

  void cycle() {
    const motion::FeedDemand demand = control.advance(cut_);
    cut_.frame_is_new = false;
    if (control.event() != motion::ForceEvent::none) events.push_back(control.event());
    feed_ = 0.0;
    if (cut_.is_controllable)
      feed_ = demand.feed_per_s > 0.0 ? demand.feed_per_s : cut_.feed_programmed;
    cut_.path_speed = feed_;
    cut_.power_w = plant.advance(feed_, cut_.cycle_s);
    time_s += cut_.cycle_s;
  }

  [[nodiscard]] bool is_fault() const {
    return control.status().state == motion::ForceState::fault;
  }
  [[nodiscard]] double feed_per_rev() const { return feed_ / rev_per_s_; }

  process::ForceControl control;
  TurningPlant plant;
  std::vector<motion::ForceEvent> events;
  double time_s = 0.0;

 private:
  double rev_per_s_;
  motion::CutState cut_;
  double feed_ = 0.0;
};

// Feed per revolution at which the plant has this force at this depth.
inline double feed_for(const TurningScene& scene, double force_n, double depth_mm) {
  TurningPlant plant(scene, 1);
  plant.depth_mm = depth_mm;
  double low = 1e-4;
  double high = 10.0;
  for (int k = 0; k < 80; ++k) {
    const double middle = std::sqrt(low * high);
    (plant.force(middle) < force_n ? low : high) = middle;
  }
  return low;
}

}  // namespace stanok::testing
