// What an oscillation of the cutting force must be, and which can be formed at all.
//
// Equation (2) of the system lost its squares in print; a force of frequency f and amplitude P on a
// mass m that swings by itself at w_d with a0 moves it by P / (m |w_d^2 - (2 pi f)^2|), and the
// self- oscillation dies out when that is a0 / sqrt(2) (asynchronous quenching of van der Pol's
// equation):
//   P_osc >= (a0 / sqrt 2) m_d |w_d^2 - (2 pi f)^2|.
// The feed acts on the force through the thickness of the chip, the travel of the tool over one
// revolution T: an oscillation of the feed is averaged over T, by |sin(pi f T) / (pi f T)|, and at
// f = k n / 60 no force swings at all. Real-time.
#pragma once

#include "base/rt_safe.h"
#include "process/adaptive/vibration_amplifier.h"

namespace stanok::process {

struct Oscillation {
  double force_n = 0.0;  // amplitude; 0: none
  double frequency_hz = 0.0;
};

// Equation (2), N; mass in kg, frequency in Hz.
[[nodiscard]] double quenching_force_n(const Vibration& self_oscillation, double mass_kg,
                                       double frequency_hz) RT_SAFE;

// How much of an oscillation of the feed arrives in the thickness of the chip, 0 to 1.
[[nodiscard]] double chip_part(double frequency_hz, double revolution_s) RT_SAFE;

// The frequency itself, or, near a multiple of the spindle's, one half way to the next multiple.
[[nodiscard]] double formable_frequency(double frequency_hz, double revolution_s) RT_SAFE;

}  // namespace stanok::process
