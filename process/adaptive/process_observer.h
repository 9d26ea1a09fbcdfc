// ProcessObserver: what may be concluded from the power of a cut, and how far the feed may rise.
//
// Three questions, each with an answer of its own:
//   Is there a value?        Not a number: the sensor is lost.
//   Does it answer?          The feed rises by one step over the last one that was answered to
//                            (FeedRatchet). A power that stays although the feed has fallen to
//                            S_min at once is stuck, too.
//   Is its gain that of the machine? Power alone cannot tell a lost gain from a lighter cut: both
//                            give the same record at every feed. The cut is taken to be no more
//                            than `lighter_max` lighter than the reference: what it took before in
//                            this cut, or, until that is known, what it takes at the programmed
//                            feed. Where the program gives the depth, the reference changes in
//                            proportion to it, and is known better. In the air and in the cut no
//                            spindle draws less than a part of its idle power.
// docs/process/dead-sensors.md proves both bounds of the force. Owned by the force control of a
// channel, in the cycle; allocates nothing.
#pragma once

#include <limits>

#include "base/rt_safe.h"
#include "motion/segments/feed_modifier.h"
#include "process/adaptive/fallen_feed.h"
#include "process/adaptive/feed_ratchet.h"
#include "process/adaptive/force_control_config.h"
#include "process/adaptive/sensor_count.h"

namespace stanok::process {

class ProcessObserver {
 public:
  explicit ProcessObserver(const ForceControlConfig& config) : config_(config), ratchet_(config) {}

  struct Inputs {
    double cycle_s = 0.001;
    double power_w = 0.0;
    double power_idle_w = 0.0;
    double force_n = 0.0;   // that the power means
    double wanted_n = 0.0;  // setpoint
    double watt_per_newton = 1.0;
    double feed = 0.0;             // that the controller asks for, mm/rev
    double feed_max = 0.0;         // S_max, mm/rev
    double feed_programmed = 0.0;  // mm/rev
    double revolution_s = 0.1;
    double measuring_s = 0.0;  // of the force, beyond chip and sensor
    bool cuts = false;
    bool is_rapid = false;       // the tool has left the workpiece
    bool follows = false;        // the path goes at the feed asked for
    bool is_at_speed = false;    // the spindle, as long as it takes the sensor to show it
    bool is_at_minimum = false;  // the feed is S_min
  };
  void look(const Inputs& inputs) RT_SAFE;
  // The depth that the program has given stays.
  void reset() RT_SAFE {
    const double depth_mm = depth_mm_;
    *this = ProcessObserver(config_);
    depth_mm_ = depth_mm;
  }
  // The depth of the cut, as the program gives it; 0: not known. What was measured belongs to the
  // one before.
  void give_depth(double depth_mm) RT_SAFE {
    if (depth_mm == depth_mm_) return;
    depth_mm_ = depth_mm;
    ratchet_.leave_cut();
  }
  // Another setpoint of the force, and with it another feed.
  void scale(double feed_factor) RT_SAFE { ratchet_.scale(feed_factor); }

  [[nodiscard]] motion::PowerDoubt doubt() const RT_SAFE { return doubt_; }
  // What the feed may be, mm/rev.
  [[nodiscard]] double feed_max() const RT_SAFE { return feed_max_; }
  // A feed that would rise further if the cut might be lighter.
  [[nodiscard]] bool is_at_reference(double feed) const RT_SAFE;
  [[nodiscard]] motion::CutReference reference() const RT_SAFE { return reference_; }
  // The largest force of an unchanged cut, whatever the sensor shows from now on, over the
  // setpoint; 0: without a bound, as before a cut was measured.
  [[nodiscard]] double worst_part() const RT_SAFE;

 private:
  [[nodiscard]] bool is_below_idle(const Inputs& inputs) RT_SAFE;
  void learn_reference() RT_SAFE;
  // The depth of the cut and that of the reference.
  [[nodiscard]] bool knows_depth() const RT_SAFE {
    return depth_mm_ > 0.0 && taken_depth_mm_ > 0.0;
  }
  // By which the cut of the program takes more force than that of the reference.
  [[nodiscard]] double depth_part() const RT_SAFE;
  // By which the cut may be lighter than the reference.
  [[nodiscard]] double lighter_max() const RT_SAFE;
  [[nodiscard]] double feed_by_reference(const Inputs& inputs) RT_SAFE;

  ForceControlConfig config_;
  SensorCount count_;
  FeedRatchet ratchet_;
  FallenFeed fallen_;
  double below_idle_s_ = 0.0;
  bool is_learnt_ = false;       // in this cut
  Measured taken_;               // the heaviest in this cut, or else in the one before; 0 N: none
  double taken_depth_mm_ = 0.0;  // at that; 0: not known
  double depth_mm_ = 0.0;        // as the program gives it
  motion::PowerDoubt doubt_ = motion::PowerDoubt::none;
  motion::CutReference reference_ = motion::CutReference::none;
  double feed_max_ = std::numeric_limits<double>::infinity();
  double reference_max_ = std::numeric_limits<double>::infinity();
};

}  // namespace stanok::process
