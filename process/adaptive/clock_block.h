// ClockBlock and RapidKey, blocks 22 and 23: the code of the clock that drives the interpolator,
// formed from the power setpoint, and the way round it for rapid moves.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "process/adaptive/power_correction.h"

namespace stanok::process {

// Block 22. The printed block follows N_z itself; facing at constant speed N_z falls with the
// radius and the feed with it, while the force needs the same feed. Normalised by w R it is the
// force setpoint: the feed goes as it swings about its mean, and does not see speed and radius.
[[nodiscard]] inline double clock_part(const ComputingBlock& computing, double power_w,
                                       double force_mean_n) RT_SAFE {
  if (force_mean_n <= 0.0) return 1.0;
  const double mean_w = computing.power_w(force_mean_n);
  return mean_w > 0.0 ? power_w / mean_w : 1.0;
}

enum class Traverse : std::uint8_t { feed, rapid };

// Block 23: in rapid traverse the code of block 1, as it is.
[[nodiscard]] constexpr double rapid_key(Traverse traverse, double code_of_program,
                                         double code_of_clock) RT_SAFE {
  return traverse == Traverse::rapid ? code_of_program : code_of_clock;
}

}  // namespace stanok::process
