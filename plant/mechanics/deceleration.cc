// Closed forms of a body that comes to rest.
#include "plant/mechanics/deceleration.h"

#include <algorithm>
#include <cmath>

namespace stanok::plant {

Motion decelerated(const Motion& motion, double deceleration, double dt_s) RT_SAFE {
  const double speed = std::fabs(motion.velocity);
  const double moving_s = std::min(dt_s, speed / deceleration);
  const double direction = motion.velocity < 0.0 ? -1.0 : 1.0;
  const double end_speed = speed - deceleration * moving_s;
  const bool at_rest = moving_s < dt_s;
  return {.position = motion.position + direction * 0.5 * (speed + end_speed) * moving_s,
          .velocity = at_rest ? 0.0 : direction * end_speed,
          .acceleration = at_rest ? 0.0 : -direction * deceleration};
}

Motion coasted(const Motion& motion, double time_constant_s, double dt_s) RT_SAFE {
  const double remaining = std::exp(-dt_s / time_constant_s);
  const double velocity = motion.velocity * remaining;
  return {.position = motion.position + motion.velocity * time_constant_s * (1.0 - remaining),
          .velocity = velocity,
          .acceleration = -velocity / time_constant_s};
}

}  // namespace stanok::plant
