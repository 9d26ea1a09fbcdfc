// The law of the controller, and where its rates come from.
#include "motion/threads/position_controller.h"

#include <algorithm>

#include "base/assert.h"

namespace stanok::motion {

SetpointRates coming_rates(const kinematics::Jet& setpoint, double cycle_s) RT_SAFE {
  const auto [position, velocity, acceleration, jerk] = setpoint;
  const double half = 0.5 * cycle_s;
  return {.velocity = velocity + half * (acceleration + cycle_s * jerk / 3.0),
          .acceleration = acceleration + half * jerk,
          .jerk = jerk};
}

CodeDifferences::CodeDifferences(std::int64_t position_code, double resolution, double cycle_s)
    : resolution_(resolution), cycle_s_(cycle_s), code_before_(position_code) {
  STANOK_ASSERT(resolution > 0.0 && cycle_s > 0.0);
}

SetpointRates CodeDifferences::advance(std::int64_t position_code) RT_SAFE {
  SetpointRates rates;
  rates.velocity = static_cast<double>(position_code - code_before_) * resolution_ / cycle_s_;
  rates.acceleration = (rates.velocity - before_.velocity) / cycle_s_;
  rates.jerk = (rates.acceleration - before_.acceleration) / cycle_s_;
  code_before_ = position_code;
  before_ = rates;
  return rates;
}

PositionController::PositionController(const ControllerGains& gains, double demand_max)
    : gains_(gains), demand_max_(demand_max) {
  STANOK_ASSERT(demand_max > 0.0);
}

double PositionController::demand(double error, const SetpointRates& coming) RT_SAFE {
  const double change = has_error_before_ ? error - error_before_ : 0.0;
  const double sum = error_sum_ + error;
  const double wanted = gains_.kp * error + gains_.kd * change + gains_.kint * sum +
                        gains_.kv * coming.velocity + gains_.ka * coming.acceleration +
                        gains_.kr * coming.jerk;
  const double given = std::clamp(wanted, -demand_max_, demand_max_);
  const bool winds_up = wanted != given && (wanted > given) == (error > 0.0);
  if (!winds_up) error_sum_ = sum;
  error_before_ = error;
  has_error_before_ = true;
  return given;
}

void PositionController::reset() RT_SAFE {
  error_sum_ = 0.0;
  has_error_before_ = false;
}

}  // namespace stanok::motion
