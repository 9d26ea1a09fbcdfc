// Phases of constant jerk from a spline of squared speed, and the proof that they keep the limits.
//
// Each interval becomes two phases of equal duration that meet speed and acceleration of the spline
// at both of its ends exactly. What they ask of the axes is evaluated from their own speeds,
// accelerations and jerks, not from the spline's (docs/developer/motion.md#optimum).
#pragma once

#include <cstddef>
#include <vector>

#include "motion/time_optimum/limit_grid.h"
#include "motion/time_optimum/speed_optimum.h"

namespace stanok::motion {

// Appends the phases of the spline, whose stretch begins at `s0`.
void append_phases(const LimitGrid& grid, const SpeedSpline& spline, double s0,
                   std::vector<Phase>& phases);

// What phases ask of the machine axes, as parts of their limits: the largest over all axes.
struct PhaseUse {
  double speed = 0.0;     // of the feed and of velocities, squared
  double force = 0.0;     // of accelerations and jerks
  double velocity = 0.0;  // |velocity| / a_max, s
  double thrust = 0.0;    // |velocity| / j_max, s^2
  double coupling = 0.0;  // |acceleration| / j_max, s

  void include(const PhaseUse& other);
  // With which the phases may be run more slowly.
  [[nodiscard]] PaceLimits pace_limits() const;
};

// Of an interval, whose two phases these are: at five places of each phase, with half as much
// again of what may lie between them to second order (motion/path/sampling.h).
[[nodiscard]] PhaseUse use_of(const LimitGrid& grid, std::size_t interval, const Phase& first,
                              const Phase& second);

}  // namespace stanok::motion
