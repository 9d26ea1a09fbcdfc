// ComputingBlock and Comparator, blocks 12 and 13: the power that the force setpoint means, and
// how far the measured one is from it. With the compensator they form the correction, block 15.
#pragma once

#include <numbers>

#include "base/rt_safe.h"

namespace stanok::process {

constexpr double s_per_min = 60.0;

// rad/s of a spindle.
[[nodiscard]] constexpr double angular_speed(double rev_per_min) RT_SAFE {
  return 2.0 * std::numbers::pi * rev_per_min / s_per_min;
}

// Block 12, equation (3): N_z = P_z w R in W, with the force in N, w in rad/s, R in mm; divided by
// the efficiency of the spindle drive it is what the sensor sees.
struct ComputingBlock {
  double omega = 0.0;
  double radius_mm = 0.0;
  double efficiency = 1.0;

  [[nodiscard]] double power_w(double force_n) const RT_SAFE {
    constexpr double m_per_mm = 1e-3;
    return force_n * omega * radius_mm * m_per_mm / efficiency;
  }
  // Equation (1) for the force; 0 where the power says nothing of it.
  [[nodiscard]] double force_n(double cutting_power_w) const RT_SAFE {
    const double power_of_one_n = power_w(1.0);
    return power_of_one_n > 0.0 ? cutting_power_w / power_of_one_n : 0.0;
  }
};

// Block 13, equation (4): U = N_d - N_x - N_z; above zero the tool is overloaded.
[[nodiscard]] constexpr double deviation_w(double measured_w, double idle_w, double wanted_w)
    RT_SAFE {
  return measured_w - idle_w - wanted_w;
}

}  // namespace stanok::process
