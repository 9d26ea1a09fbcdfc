// Position controller of one axis whose loop is closed in the cycle: the velocity demand of its
// drive.
//
//   U = kp e + kd (change of e) + kint (sum of e) + kv V + ka A + kr J
//
// e is the following error at the start of a cycle; V, A and J are what the setpoint will do in
// that cycle. Source: V. Kombarov, V. Sorokin, stability of contour feed (2013), eq. (16), and
// eqs. (1) to (4) for the rates that differences of integer positions give.
// docs/developer/motion.md derives the gains. Units: mm or deg, s.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "kinematics/jet.h"

namespace stanok::motion {

struct ControllerGains {
  double kp = 0.0;    // 1/s
  double kd = 0.0;    // 1/s
  double kint = 0.0;  // 1/s
  double kv = 1.0;
  double ka = 0.0;  // s
  double kr = 0.0;  // s^2
};

// Mean rates of change of a setpoint over a cycle, per s, s^2, s^3.
struct SetpointRates {
  double velocity = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

// Over the time T that begins at the instant of `setpoint`: the cycle for which U will stand. Exact
// while the jerk is constant; a step of the jerk by J within it is an error of the velocity of at
// most J T^2 / 6.
[[nodiscard]] SetpointRates coming_rates(const kinematics::Jet& setpoint, double cycle_s) RT_SAFE;

// The rates as a control has them that passes on integer positions only: eqs. (1), (3) and (4). The
// rounding of a position appears in them divided by T, T^2 and T^3.
class CodeDifferences {
 public:
  // Stands at `position_code`; `resolution` in mm or deg per increment.
  CodeDifferences(std::int64_t position_code, double resolution, double cycle_s);

  // Over the cycle that leads to `position_code`.
  [[nodiscard]] SetpointRates advance(std::int64_t position_code) RT_SAFE;

 private:
  double resolution_;
  double cycle_s_;
  std::int64_t code_before_;
  SetpointRates before_;
};

class PositionController {
 public:
  PositionController() = default;
  // The drive is asked for at most `demand_max` either way; > 0.
  PositionController(const ControllerGains& gains, double demand_max);

  // U for the coming cycle. `error` is setpoint less position, both of the instant at which that
  // cycle begins. The sum of errors stands still while U is at its limit, unless it comes back.
  [[nodiscard]] double demand(double error, const SetpointRates& coming) RT_SAFE;

  // Forgets the sum and the error before: for as long as the drive does not hold the axis.
  void reset() RT_SAFE;

 private:
  ControllerGains gains_;
  double demand_max_ = 0.0;
  double error_sum_ = 0.0;
  double error_before_ = 0.0;
  bool has_error_before_ = false;
};

}  // namespace stanok::motion
