// Closed forms of the earliest stop (motion/bounds/limit_guard.h).
#include "motion/bounds/limit_guard.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {

double stopping_distance(double v, double a, double acceleration_max, double jerk_max) RT_SAFE {
  if (std::isinf(jerk_max)) return v > 0.0 ? v * v / (2.0 * acceleration_max) : 0.0;
  const double square = a * a + 2.0 * jerk_max * v;
  if (square < 0.0 || (v <= 0.0 && a <= 0.0)) return 0.0;
  const double a_at_rest = -std::sqrt(square);
  if (-a_at_rest <= acceleration_max) {
    const double t = (a - a_at_rest) / jerk_max;
    return std::max(0.0, t * (v + t * (a / 2.0 - jerk_max * t / 6.0)));
  }
  const double t = std::max(0.0, (a + acceleration_max) / jerk_max);
  const double v_at_limit = v + t * (a - jerk_max * t / 2.0);
  const double on_the_way = t * (v + t * (a / 2.0 - jerk_max * t / 6.0));
  return on_the_way + v_at_limit * v_at_limit / (2.0 * acceleration_max);
}

bool passes_limit(const kinematics::Jet& axis, const AxisLimits& limits, double slack) RT_SAFE {
  const auto farthest = [&](double sign) RT_SAFE {
    return stopping_distance(sign * axis.first, sign * axis.second,
                             limits.stop_limits * limits.acceleration_max,
                             limits.stop_limits * limits.jerk_max);
  };
  if (axis.first > 0.0 && axis.value + farthest(1.0) > limits.position_max + slack) return true;
  return axis.first < 0.0 && axis.value - farthest(-1.0) < limits.position_min - slack;
}

}  // namespace stanok::motion
