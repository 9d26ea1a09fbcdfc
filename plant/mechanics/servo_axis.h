// A feed axis in the mode of cyclic synchronous velocities: a velocity loop of second order on the
// motor, and the load on a spring. Its position loop is closed elsewhere.
//
// With the velocity v of the motor, the position y of the load and the stretch e of the spring:
//   v'' = w^2 (U - v) - 2 d w v'     e' = v - y'     y'' = r^2 e + 2 h r e'
// The position is that of the load, as a linear scale reads it. U is constant within a step, and
// the step is the exact solution, whatever its length (docs/integrator/drives.md#plant).
#pragma once

#include <array>

#include "plant/mechanics/motor.h"
#include "plant/mechanics/plant_config.h"

namespace stanok::plant {

class ServoAxis final : public Motor {
 public:
  // Of `axis` the limits, decelerations and powers count, not its position loop.
  ServoAxis(const VelocityLoopConfig& loop, const AxisPlantConfig& axis, double start);

  // Only the velocity of the demand moves it.
  void follow(const Demand& demand, double dt_s) RT_SAFE override;
  void ramp_down(double dt_s) RT_SAFE override;
  void coast(double dt_s) RT_SAFE override;
  void hold_by_brake(double dt_s) RT_SAFE override;
  void shift_position(double distance) RT_SAFE override { motion_.position += distance; }

  [[nodiscard]] const Motion& motion() const RT_SAFE override { return motion_; }
  [[nodiscard]] double following_error(const Demand& demand) const RT_SAFE override {
    return demand.position - motion_.position;
  }
  [[nodiscard]] double power_w() const RT_SAFE override;

 private:
  // Travel of the load in the step, velocity of the load, stretch of the spring times r, velocity
  // of the motor, its acceleration over w, demand: all in mm/s or deg/s but the first.
  static constexpr std::size_t state_size = 6;
  using State = std::array<double, state_size>;
  using Matrix = std::array<State, state_size>;

  [[nodiscard]] static Matrix product(const Matrix& a, const Matrix& b) RT_SAFE;
  [[nodiscard]] Matrix rates() const RT_SAFE;
  [[nodiscard]] Matrix transition(double dt_s) const RT_SAFE;
  void move_rigidly(const Motion& motion) RT_SAFE;

  VelocityLoopConfig loop_;
  AxisPlantConfig config_;
  Motion motion_;
  State state_{};
  Matrix transition_{};
  double transition_dt_s_ = 0.0;  // of which `transition_` is
};

}  // namespace stanok::plant
