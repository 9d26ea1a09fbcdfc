// A spindle: speed ramps at constant acceleration, idle power grows with speed.
//
// Velocity is the speed in rev/min, signed (M3 positive); position is the angle within one turn,
// 0 <= angle < 360 deg. It follows the velocity of the demand only.
#pragma once

#include "plant/mechanics/motor.h"
#include "plant/mechanics/plant_config.h"

namespace stanok::plant {

class SpindlePlant final : public Motor {
 public:
  explicit SpindlePlant(const SpindlePlantConfig& config);

  void follow(const Demand& demand, double dt_s) RT_SAFE override;
  void ramp_down(double dt_s) RT_SAFE override;
  void coast(double dt_s) RT_SAFE override;
  void hold_by_brake(double dt_s) RT_SAFE override { ramp_down(dt_s); }
  void shift_position(double distance) RT_SAFE override;

  [[nodiscard]] const Motion& motion() const RT_SAFE override { return motion_; }
  [[nodiscard]] double following_error(const Demand&) const RT_SAFE override { return 0.0; }
  // Idle power P (n/2 + n^2/2) with n the share of the greatest speed, and the power that
  // accelerates the rotor; braking gives power back (negative).
  [[nodiscard]] double power_w() const RT_SAFE override;

 private:
  void turn(double speed_before, double dt_s) RT_SAFE;

  SpindlePlantConfig config_;
  Motion motion_;
};

}  // namespace stanok::plant
