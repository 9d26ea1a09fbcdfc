// Exact step of the second-order position loop.
#include "plant/mechanics/axis_plant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plant/mechanics/deceleration.h"

namespace stanok::plant {
namespace {

// The two fundamental solutions of y'' + 2 d w y' + w^2 y = 0 at time t, without the factor
// exp(-d w t): C = cos(b t) and S = sin(b t)/b with b = w sqrt(1 - d^2), and their limits for
// d = 1 and d > 1.
struct Fundamental {
  double c;
  double s;
};

Fundamental fundamental(double w, double d, double t) RT_SAFE {
  const double b_squared = w * w * (1.0 - d * d);
  const double b = std::sqrt(std::fabs(b_squared));
  if (b * t < 1e-9) {
    return {1.0, t};
  }
  return b_squared > 0.0 ? Fundamental{std::cos(b * t), std::sin(b * t) / b}
                         : Fundamental{std::cosh(b * t), std::sinh(b * t) / b};
}

}  // namespace

double axis_power_w(const AxisPlantConfig& config, const Motion& motion) RT_SAFE {
  return config.power_idle_w + config.friction_w_per_unit * std::fabs(motion.velocity) +
         config.inertia_w_per_unit * motion.velocity * motion.acceleration;
}

AxisPlant::AxisPlant(const AxisPlantConfig& config, double start)
    : config_(config), motion_{.position = start} {}

// In the frame of the demand, y = x - p - y_end with the steady error y_end = 2 d (k - 1) v / w -
// f / w^2 obeys the homogeneous equation. Friction that would turn the motion round brings it to
// rest.
void AxisPlant::follow(const Demand& demand, double dt_s) RT_SAFE {
  const double w = 2.0 * std::numbers::pi * config_.bandwidth_hz;
  const double d = config_.damping;
  const double v = demand.velocity;
  const double position_before = motion_.position;
  const double demand_before = demand.position - v * dt_s;
  const double force = w * w * (demand_before - position_before) +
                       2.0 * d * w * (config_.velocity_feed_forward * v - motion_.velocity);
  if (motion_.velocity == 0.0 && std::fabs(force) < config_.dry_friction) {
    motion_.acceleration = 0.0;
    return;  // held by friction
  }
  const double moves_to = motion_.velocity != 0.0 ? motion_.velocity : force;
  const double friction = std::copysign(config_.dry_friction, moves_to);
  const double y_end = 2.0 * d * (config_.velocity_feed_forward - 1.0) * v / w - friction / (w * w);

  const double y = motion_.position - demand_before - y_end;
  const double dy = motion_.velocity - v;
  const auto [c, s] = fundamental(w, d, dt_s);
  const double decay = std::exp(-d * w * dt_s);
  const double y_after = decay * (y * c + (dy + d * w * y) * s);
  const double dy_after = decay * (dy * c - (d * w * dy + w * w * y) * s);

  motion_.position = demand.position + y_end + y_after;
  motion_.velocity = v + dy_after;
  motion_.acceleration = -2.0 * d * w * dy_after - w * w * y_after;
  if (motion_.velocity * friction < 0.0) motion_.velocity = 0.0;
  limit_velocity(position_before, dt_s);
}

void AxisPlant::limit_velocity(double position_before, double dt_s) RT_SAFE {
  const double limit = config_.velocity_max;
  if (limit <= 0.0) {
    return;
  }
  const double reach = limit * dt_s;
  motion_.position = std::clamp(motion_.position, position_before - reach, position_before + reach);
  motion_.velocity = std::clamp(motion_.velocity, -limit, limit);
}

void AxisPlant::ramp_down(double dt_s) RT_SAFE {
  motion_ = decelerated(motion_, config_.quick_stop_deceleration, dt_s);
}

void AxisPlant::coast(double dt_s) RT_SAFE {
  motion_ = coasted(motion_, config_.coasting_time_s, dt_s);
}

void AxisPlant::hold_by_brake(double dt_s) RT_SAFE {
  motion_ = decelerated(motion_, config_.brake_deceleration, dt_s);
}

}  // namespace stanok::plant
