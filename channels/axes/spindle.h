// The commanded side of one spindle in the cycle: speed ramps with its acceleration, "at speed",
// override, angle.
#pragma once

#include "base/rt_safe.h"
#include "base/units.h"
#include "channels/contract/machine_config.h"
#include "lang/contract/command.h"

namespace stanok::channels {

class Spindle {
 public:
  Spindle() = default;
  explicit Spindle(const SpindleConfig& config)
      : id_(config.id),
        speeds_{config.speed_min, config.speed_max},
        acceleration_(config.acceleration),
        wait_at_speed_(config.wait_at_speed) {}

  [[nodiscard]] int id() const RT_SAFE { return id_; }
  void command(const lang::SpindleCommand& command) RT_SAFE;
  // G96 and G97: from now on the speed follows the diameter, or stays where it is.
  void command(const lang::CuttingSpeedMode& mode) RT_SAFE;
  // What a feed law asks of a spindle that turns: a speed, or a cutting speed in m/min.
  void run_at(double rev_per_min) RT_SAFE;
  void cut_at(double m_per_min) RT_SAFE { cutting_speed_ = m_per_min; }
  // Under constant cutting speed: the tool stands at this diameter.
  void follow_diameter(double diameter_mm) RT_SAFE;
  void stop() RT_SAFE { direction_ = 0; }

  // Tapping, until the next command. Comes to rest after `turns`, or as soon as it can.
  void stop_within(double turns) RT_SAFE;
  // Turns against its direction, `factor` times as fast, with this acceleration in rev/min/s, both
  // as far as it can.
  void turn_back(double factor, double acceleration) RT_SAFE;
  // Turns at this speed, clockwise > 0, with this acceleration as far as it can.
  void turn_out(double rev_per_min, double acceleration) RT_SAFE;
  // Turns again as it is commanded.
  void go_on() RT_SAFE;

  // Stands whatever it is commanded, until it may turn again.
  void rest() RT_SAFE { rests_ = true; }
  void turn_again() RT_SAFE { rests_ = false; }

  void set_override(double factor) RT_SAFE { override_ = factor; }
  // One cycle of `period_s`.
  void advance(double period_s) RT_SAFE;

  [[nodiscard]] double speed() const RT_SAFE { return speed_; }  // rev/min, signed: clockwise > 0
  [[nodiscard]] double turns() const RT_SAFE { return turns_; }  // since power-on, signed
  [[nodiscard]] double angle_deg() const RT_SAFE { return angle_deg_; }  // in [0, 360)
  void set_angle(double angle_deg) RT_SAFE;                              // any whole turns
  // As it is commanded, rev/min, signed, before its override.
  [[nodiscard]] double commanded() const RT_SAFE { return direction_ * programmed_; }
  [[nodiscard]] bool is_settled() const RT_SAFE { return !wait_at_speed_ || speed_ == target(); }
  [[nodiscard]] double target() const RT_SAFE;  // rev/min, signed: that it comes to

 private:
  struct Speeds {
    double min = 0.0;
    double max = 0.0;
  };

  int id_ = 0;
  Speeds speeds_;
  double acceleration_ = 0.0;  // rev/min/s; 0 = at once
  bool wait_at_speed_ = true;
  double programmed_ = 0.0;
  double cutting_speed_ = 0.0;  // m/min; 0: the speed does not follow the diameter
  double speed_limit_ = 0.0;    // of G96, rev/min; 0: none
  double override_ = 1.0;
  int direction_ = 0;
  bool rests_ = false;
  double share_ = 1.0;               // of the commanded speed: below zero back, 0 at rest
  double acceleration_asked_ = 0.0;  // rev/min/s; 0: that of the machine file
  double speed_ = 0.0;
  double turns_ = 0.0;
  double angle_deg_ = 0.0;
};

}  // namespace stanok::channels
