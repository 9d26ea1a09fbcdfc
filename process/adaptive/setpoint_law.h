// SetpointLaw, block 21: the setpoint of the cutting force over time.
//
// Constant; with an oscillation that the program commands; or with one that follows the vibration
// that is there (quenching_law.h). For the feed ahead (blocks 12 and 22) the oscillation is
// emphasised by what chip thickness, force exponent and feed drives take away from it. Real-time.
#pragma once

#include "base/rt_safe.h"
#include "motion/segments/feed_modifier.h"
#include "process/adaptive/force_control_config.h"
#include "process/adaptive/quenching_law.h"
#include "process/adaptive/vibration_amplifier.h"

namespace stanok::process {

struct ForceSetpoint {
  double mean_n = 0.0;
  double now_n = 0.0;         // what the force shall be
  double sensed_n = 0.0;      // the same, as late as chip and power sensor show it
  double emphasised_n = 0.0;  // what the feed ahead is formed from
};

class SetpointLaw {
 public:
  explicit SetpointLaw(const ForceControlConfig& config)
      : config_(config), quenching_(config.oscillation_reserve) {}

  void set_mean(double force_n) RT_SAFE { mean_n_ = force_n; }
  [[nodiscard]] double mean_n() const RT_SAFE { return mean_n_; }
  void set_programmed(const Oscillation& oscillation) RT_SAFE;
  // Automatic oscillation of this frequency, for this reduced mass; 0: none is formed.
  void set_automatic(double mass_kg, double frequency_hz) RT_SAFE;
  [[nodiscard]] bool can_form() const RT_SAFE { return quenching_.can_form(); }
  [[nodiscard]] double mass_kg() const RT_SAFE { return quenching_.mass_kg(); }

  struct Inputs {
    double cycle_s = 0.001;
    double revolution_s = 0.1;
    Vibration vibration{};  // behind the dead zone
    Vibration sensed{};     // in front of it
    double least_um = 0.0;  // below it a vibration needs no oscillation
    bool cuts = false;
  };
  [[nodiscard]] ForceSetpoint advance(const Inputs& inputs) RT_SAFE;

  // The oscillation as it is formed now.
  [[nodiscard]] const Oscillation& oscillation() const RT_SAFE { return formed_; }
  // What the latest cycle had to change of what was asked for.
  [[nodiscard]] motion::ForceEvent event() const RT_SAFE { return event_; }

 private:
  [[nodiscard]] double sensed_swing(double revolution_s) const RT_SAFE;
  void form(const Oscillation& wanted, double revolution_s) RT_SAFE;

  ForceControlConfig config_;
  double mean_n_ = 0.0;
  Oscillation programmed_;
  QuenchingLaw quenching_;

  Oscillation formed_;
  double emphasis_ = 1.0;
  double phase_ = 0.0;  // rad
  bool was_shifted_ = false;
  bool was_limited_ = false;
  motion::ForceEvent event_ = motion::ForceEvent::none;
};

}  // namespace stanok::process
