// A feed axis: position loop of second order with velocity feed-forward.
//
// x'' = w^2 (p - x) + 2 d w (k v - x') - f sign x', with f the dry friction per mass. For a demand
// that moves at constant velocity the step is the exact solution, whatever its length
// (docs/integrator/drives.md#plant); only the velocity limit and the instant at which dry friction
// holds the axis depend on the step.
#pragma once

#include "plant/mechanics/motor.h"
#include "plant/mechanics/plant_config.h"

namespace stanok::plant {

// Electrical power of a feed axis: idle, friction, and what changes its speed.
[[nodiscard]] double axis_power_w(const AxisPlantConfig& config, const Motion& motion) RT_SAFE;

class AxisPlant final : public Motor {
 public:
  AxisPlant(const AxisPlantConfig& config, double start);

  void follow(const Demand& demand, double dt_s) RT_SAFE override;
  void ramp_down(double dt_s) RT_SAFE override;
  void coast(double dt_s) RT_SAFE override;
  void hold_by_brake(double dt_s) RT_SAFE override;
  void shift_position(double distance) RT_SAFE override { motion_.position += distance; }

  [[nodiscard]] const Motion& motion() const RT_SAFE override { return motion_; }
  [[nodiscard]] double following_error(const Demand& demand) const RT_SAFE override {
    return demand.position - motion_.position;
  }
  [[nodiscard]] double power_w() const RT_SAFE override { return axis_power_w(config_, motion_); }

 private:
  void limit_velocity(double position_before, double dt_s) RT_SAFE;

  AxisPlantConfig config_;
  Motion motion_;
};

}  // namespace stanok::plant
