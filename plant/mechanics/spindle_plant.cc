// Speed ramp, angle and power of a spindle.
#include "plant/mechanics/spindle_plant.h"

#include <algorithm>
#include <cmath>

#include "plant/mechanics/deceleration.h"

namespace stanok::plant {
namespace {

constexpr double deg_per_s_per_rpm = 360.0 / 60.0;

double within_one_turn(double angle_deg) RT_SAFE {
  const double angle = std::fmod(angle_deg, 360.0);
  return angle < 0.0 ? angle + 360.0 : angle;
}

}  // namespace

SpindlePlant::SpindlePlant(const SpindlePlantConfig& config) : config_(config) {}

void SpindlePlant::follow(const Demand& demand, double dt_s) RT_SAFE {
  const double before = motion_.velocity;
  const double wanted = std::clamp(demand.velocity, -config_.speed_max, config_.speed_max);
  const double ramp = config_.acceleration * dt_s;
  const double change =
      config_.acceleration > 0.0 ? std::clamp(wanted - before, -ramp, ramp) : wanted - before;
  motion_.velocity = before + change;
  motion_.acceleration = config_.acceleration > 0.0 ? change / dt_s : 0.0;
  turn(before, dt_s);
}

void SpindlePlant::ramp_down(double dt_s) RT_SAFE {
  follow({.velocity = 0.0}, dt_s);
}

void SpindlePlant::coast(double dt_s) RT_SAFE {
  const double before = motion_.velocity;
  motion_.velocity = coasted(motion_, config_.coasting_time_s, dt_s).velocity;
  motion_.acceleration = 0.0;  // no power flows
  turn(before, dt_s);
}

void SpindlePlant::shift_position(double distance) RT_SAFE {
  motion_.position = within_one_turn(motion_.position + distance);
}

void SpindlePlant::turn(double speed_before, double dt_s) RT_SAFE {
  const double mean_speed = 0.5 * (speed_before + motion_.velocity);
  shift_position(mean_speed * deg_per_s_per_rpm * dt_s);
}

double SpindlePlant::power_w() const RT_SAFE {
  const double share = std::fabs(motion_.velocity) / config_.speed_max;
  const double idle = config_.power_idle_w * 0.5 * (share + share * share);
  if (config_.acceleration <= 0.0) {
    return idle;
  }
  const double towards_speed = motion_.velocity < 0.0 ? -1.0 : 1.0;
  const double effort = towards_speed * motion_.acceleration / config_.acceleration;
  return idle + config_.acceleration_w * share * effort;
}

}  // namespace stanok::plant
