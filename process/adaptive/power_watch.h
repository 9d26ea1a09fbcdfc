// PowerWatch: whether the power that the sensor of block 8 gives can be trusted.
//
// Lost: not a number. Stuck: the feed has changed, and the power has not answered as
// N_d - N_x ~ w R h^y demands. Whether a power lives is not read from its bits, which a dead sensor
// may flicker or drift, but from its answer: it has gone at least half the way that the change of
// the feed demands, or it has moved by itself, as it does when the cut changes. Where the feed has
// risen by 14 % without an answer it rises no further (`is_suspicious`): either the sensor is dead,
// or the cut became lighter just as fast, as on a taper; then the power falls as soon as the feed
// stands. It is given a while for that. After three such trials in vain, of which only the first
// takes so much feed, or after two in which the power only flickered, the sensor is stuck. A feed
// that falls is never kept from falling, and is judged where it has come to rest.
//
// What is compared is smoothed alike, and the feed is delayed by the chip and the lag of the
// sensor. A power that stays below a part of the idle power shows a gain that is lost, in the air
// and in the cut; where the machine file says by how much a cut may become lighter (`lighter_max`),
// so does a power that falls by more of what the feed demands: by the power alone a lost gain and a
// lighter cut are the same. The more the power is noisy the more the feed must have changed. In the
// air, where nothing answers, nothing is judged. Owned by the force control of a channel, in the
// cycle; allocates nothing.
#pragma once

#include "base/rt_safe.h"
#include "process/adaptive/force_control_config.h"
#include "process/adaptive/sensor_count.h"
#include "process/adaptive/smoothed_cut.h"

namespace stanok::process {

enum class PowerTrust { good, lost, stuck };

class PowerWatch {
 public:
  explicit PowerWatch(const ForceControlConfig& config) : config_(config) {}

  void reset() RT_SAFE { *this = PowerWatch(config_); }
  // `feed_per_rev`: that the path goes at, mm. `speed_radius`: w R, on which the power depends,
  // too.
  struct Inputs {
    double cycle_s = 0.001;
    double power_w = 0.0;
    double power_idle_w = 0.0;
    double feed_per_rev = 0.0;
    double speed_radius = 1.0;
    double revolution_s = 0.1;
    bool cuts = false;
    bool is_at_speed = false;    // of the spindle, as long as it takes the sensor to show it
    bool is_at_minimum = false;  // the feed is S_min
  };
  [[nodiscard]] PowerTrust look(const Inputs& inputs) RT_SAFE;
  // The feed has changed, and the power not yet: no reason for more of it.
  [[nodiscard]] bool is_suspicious() const RT_SAFE { return trial_.is_on; }

 private:
  // What the cut was like when the power was last seen to live.
  struct Reference {
    double feed = 0.0;      // mm/rev
    double smooth_w = 0.0;  // of the cut
    double demand = 0.0;    // w R h^y as the sensor shows it
    double left_s = 0.0;    // since the feed has left it
  };
  // Where the power or the feed last did something: the feed then, and the time since.
  struct Since {
    double feed = 0.0;  // mm/rev
    double s = 0.0;
  };
  struct Trial {
    bool is_on = false;
    double time_s = 0.0;
    double due_s = 0.0;
    double feed_least = 0.0;
    double weight = 0.0;   // in trials
    double least_w = 0.0;  // smoothed, since it began
    double most_w = 0.0;
  };

  [[nodiscard]] bool is_below_idle(const Inputs& inputs) RT_SAFE;
  [[nodiscard]] bool is_too_light(const Inputs& inputs) RT_SAFE;
  void follow(const Inputs& inputs) RT_SAFE;
  void refer(const Inputs& inputs) RT_SAFE;
  [[nodiscard]] bool lives() const RT_SAFE;
  [[nodiscard]] bool is_unanswered(const Inputs& inputs) const RT_SAFE;
  [[nodiscard]] bool falls_slowly(const Inputs& inputs) const RT_SAFE;
  [[nodiscard]] double change_in_noise() const RT_SAFE;
  [[nodiscard]] double change_of_life() const RT_SAFE;
  [[nodiscard]] double change_judged() const RT_SAFE;
  [[nodiscard]] bool only_flickers(const Inputs& inputs) const RT_SAFE;
  [[nodiscard]] double rise_per_s(const Inputs& inputs) const RT_SAFE;
  [[nodiscard]] double weight(const Inputs& inputs) const RT_SAFE;
  void begin_trial(const Inputs& inputs) RT_SAFE;
  [[nodiscard]] PowerTrust go_on_with_trial(const Inputs& inputs) RT_SAFE;

  ForceControlConfig config_;
  SensorCount count_;
  SmoothedCut cut_;
  double cutting_s_ = 0.0;
  Reference reference_;
  double steady_w_ = 0.0;  // about which the power may only flicker
  Since steady_;           // the power last did more
  Trial trial_;
  int trials_ = 0;           // in vain, one after the other
  Since chain_;              // the feed before the first of them, and since it has left that
  double rate_per_s_ = 0.0;  // at which the feed rose, of the ln of its demand
  double below_idle_s_ = 0.0;
  double engagement_ = 0.0;  // power over demand, as the cut began; 0: not yet known
};

}  // namespace stanok::process
