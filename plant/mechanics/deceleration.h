// Ways to come to rest, in closed form: a constant deceleration, and friction that grows with
// speed.
#pragma once

#include "base/rt_safe.h"
#include "plant/mechanics/motor.h"

namespace stanok::plant {

// After `dt_s` of constant deceleration towards rest; `deceleration` > 0.
[[nodiscard]] Motion decelerated(const Motion& motion, double deceleration, double dt_s) RT_SAFE;

// After `dt_s` in which the velocity falls by e every `time_constant_s`.
[[nodiscard]] Motion coasted(const Motion& motion, double time_constant_s, double dt_s) RT_SAFE;

}  // namespace stanok::plant
