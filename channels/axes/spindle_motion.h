// How a spindle turns, as its path is told: what it is commanded to do, and what its encoder
// counts.
#pragma once

#include "base/rt_safe.h"
#include "channels/axes/spindle.h"
#include "motion/threads/spindle_observer.h"
#include "motion/threads/tap_reversal.h"

namespace stanok::channels {

// The angle as an encoder of so many pulses per turn gives it; 0 pulses: to the last bit.
[[nodiscard]] double in_counts(double angle_deg, int pulses) RT_SAFE;
// As it is commanded to turn now.
[[nodiscard]] motion::SpindleMotion command_of(const Spindle& spindle) RT_SAFE;
// As it will turn at the end of the cycle that begins.
[[nodiscard]] motion::SpindleMotion coming_motion(const Spindle& spindle,
                                                  const motion::SpindleObserver& observer,
                                                  double cycle_s) RT_SAFE;
// What a tap asks of its spindle.
void obey(Spindle& spindle, const motion::SpindleOrder& order) RT_SAFE;

}  // namespace stanok::channels
