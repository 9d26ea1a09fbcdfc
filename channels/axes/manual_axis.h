// What moves by hand must know of an axis.
#pragma once

#include <cmath>

#include "base/fixed_text.h"
#include "base/rt_safe.h"
#include "channels/contract/machine_config.h"

namespace stanok::channels {

// Figures of one axis as far as it is moved by hand.
struct ManualAxis {
  FixedText<16> name;
  motion::AxisLimits limits;
  HomingConfig homing;
  double following_error_max = 0.5;
};

// What moves as long as it is asked for again comes to rest when it is not asked for so long.
inline constexpr double jog_lease_s = 0.2;

// Of its highest velocity: with that an axis moves that has no reference.
inline constexpr double unreferenced_part = 0.1;

// With which it looks for its home switch, mm/s or deg/s; an axis that does not: as without a
// reference.
[[nodiscard]] inline double search_speed(const ManualAxis& axis) RT_SAFE {
  const double search = std::abs(axis.homing.velocity);
  return search > 0.0 ? search : unreferenced_part * axis.limits.velocity_max;
}

}  // namespace stanok::channels
