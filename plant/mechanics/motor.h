// What moves an axis or a spindle in the simulation: a motor with its load, one instant at a time.
//
// Units: mm or deg of the axis (deg for spindles), s, W. Deterministic: the motion is a function of
// the calls alone.
#pragma once

#include "base/rt_safe.h"

namespace stanok::plant {

// Where the axis shall be now, and how fast the demand moves.
struct Demand {
  double position = 0.0;
  double velocity = 0.0;
};

struct Motion {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

class Motor {
 public:
  Motor() = default;
  virtual ~Motor() = default;
  Motor(const Motor&) = delete;
  Motor& operator=(const Motor&) = delete;

  // Follows the demand for `dt_s`; `demand` is that of the end of the step.
  virtual void follow(const Demand& demand, double dt_s) RT_SAFE = 0;
  // Comes to rest under power, on the quick-stop ramp.
  virtual void ramp_down(double dt_s) RT_SAFE = 0;
  // Runs out without power.
  virtual void coast(double dt_s) RT_SAFE = 0;
  // Comes to rest by the brake and stays there.
  virtual void hold_by_brake(double dt_s) RT_SAFE = 0;
  // The measuring system counts from elsewhere after it was without power.
  virtual void shift_position(double distance) RT_SAFE = 0;

  [[nodiscard]] virtual const Motion& motion() const RT_SAFE = 0;
  // Demand minus position; 0 for a motor without a position loop.
  [[nodiscard]] virtual double following_error(const Demand& demand) const RT_SAFE = 0;
  // Electrical power without the cutting process.
  [[nodiscard]] virtual double power_w() const RT_SAFE = 0;
};

}  // namespace stanok::plant
