// Exact step of velocity loop and load by the exponential of the system matrix.
#include "plant/mechanics/servo_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plant/mechanics/axis_plant.h"
#include "plant/mechanics/deceleration.h"

namespace stanok::plant {
namespace {

// Places in the state.
constexpr std::size_t way = 0;
constexpr std::size_t load_velocity = 1;
constexpr std::size_t stretch = 2;
constexpr std::size_t motor_velocity = 3;
constexpr std::size_t motor_acceleration = 4;
constexpr std::size_t demanded = 5;

// Terms of the Taylor series for a matrix of norm below 1/8: 8^-12 / 12! is below 1e-19.
constexpr int series_terms = 12;
constexpr double series_norm_max = 0.125;

}  // namespace

ServoAxis::ServoAxis(const VelocityLoopConfig& loop, const AxisPlantConfig& axis, double start)
    : loop_(loop), config_(axis), motion_{.position = start} {}

void ServoAxis::follow(const Demand& demand, double dt_s) RT_SAFE {
  const double limit = config_.velocity_max > 0.0 ? config_.velocity_max : HUGE_VAL;
  if (dt_s != transition_dt_s_) {
    transition_ = transition(dt_s);
    transition_dt_s_ = dt_s;
  }
  state_[way] = 0.0;
  state_[demanded] = std::clamp(demand.velocity, -limit, limit);
  State after{};
  for (std::size_t row = 0; row < state_size; ++row) {
    for (std::size_t k = 0; k < state_size; ++k) after[row] += transition_[row][k] * state_[k];
  }
  state_ = after;
  motion_.position += state_[way];
  motion_.velocity = state_[load_velocity];
  motion_.acceleration = 0.0;
  const Matrix rate = rates();
  for (std::size_t k = 0; k < state_size; ++k)
    motion_.acceleration += rate[load_velocity][k] * state_[k];
}

// The system x' = R x. A load without a spring is carried by the motor.
ServoAxis::Matrix ServoAxis::rates() const RT_SAFE {
  const double w = 2.0 * std::numbers::pi * loop_.bandwidth_hz;
  const double d = loop_.damping;
  const double r = 2.0 * std::numbers::pi * loop_.resonance_hz;
  const double h = loop_.resonance_damping;
  Matrix rate{};
  rate[way][load_velocity] = 1.0;
  rate[motor_velocity][motor_acceleration] = w;
  rate[motor_acceleration][motor_acceleration] = -2.0 * d * w;
  rate[motor_acceleration][motor_velocity] = -w;
  rate[motor_acceleration][demanded] = w;
  if (r == 0.0) {
    rate[load_velocity] = rate[motor_velocity];
    return rate;
  }
  rate[stretch][motor_velocity] = r;
  rate[stretch][load_velocity] = -r;
  rate[load_velocity][stretch] = r;
  rate[load_velocity][motor_velocity] = 2.0 * h * r;
  rate[load_velocity][load_velocity] = -2.0 * h * r;
  return rate;
}

// exp(R dt): the series for dt / 2^n, squared n times.
ServoAxis::Matrix ServoAxis::transition(double dt_s) const RT_SAFE {
  Matrix step = rates();
  double norm = 0.0;
  for (const State& row : step) {
    double sum = 0.0;
    for (const double value : row) sum += std::fabs(value);
    norm = std::max(norm, sum * dt_s);
  }
  const int halvings = std::max(0, std::ilogb(norm / series_norm_max) + 1);
  for (State& row : step) {
    for (double& value : row) value *= std::ldexp(dt_s, -halvings);
  }
  // Horner: 1 + A (1 + A/2 (1 + A/3 (...))).
  Matrix sum{};
  for (std::size_t k = 0; k < state_size; ++k) sum[k][k] = 1.0;
  for (int n = series_terms; n > 0; --n) {
    sum = product(step, sum);
    for (std::size_t row = 0; row < state_size; ++row) {
      for (double& value : sum[row]) value /= n;
      sum[row][row] += 1.0;
    }
  }
  for (int n = 0; n < halvings; ++n) sum = product(sum, sum);
  return sum;
}

ServoAxis::Matrix ServoAxis::product(const Matrix& a, const Matrix& b) RT_SAFE {
  Matrix c{};
  for (std::size_t row = 0; row < state_size; ++row) {
    for (std::size_t k = 0; k < state_size; ++k) {
      for (std::size_t column = 0; column < state_size; ++column)
        c[row][column] += a[row][k] * b[k][column];
    }
  }
  return c;
}

void ServoAxis::ramp_down(double dt_s) RT_SAFE {
  move_rigidly(decelerated(motion_, config_.quick_stop_deceleration, dt_s));
}

void ServoAxis::coast(double dt_s) RT_SAFE {
  move_rigidly(coasted(motion_, config_.coasting_time_s, dt_s));
}

void ServoAxis::hold_by_brake(double dt_s) RT_SAFE {
  move_rigidly(decelerated(motion_, config_.brake_deceleration, dt_s));
}

// Stops are made by motor and load together, the spring at rest.
void ServoAxis::move_rigidly(const Motion& motion) RT_SAFE {
  motion_ = motion;
  state_ = {};
  state_[load_velocity] = state_[motor_velocity] = motion.velocity;
}

double ServoAxis::power_w() const RT_SAFE {
  return axis_power_w(config_, motion_);
}

}  // namespace stanok::plant
