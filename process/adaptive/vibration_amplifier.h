// VibrationAmplifier, blocks 17 to 20: nothing within the permissible level, amplitude and
// frequency of the vibration above it.
//
// The sensor's meter (drives/vibration.h) gives amplitude and frequency of its samples; the dead
// zone acts on the amplitude. What is above the level goes on, and a0 is that and the level again,
// so that equation (2) has the whole amplitude. Once above, the amplifier is quiet again only below
// `release` of the level. Real-time.
#pragma once

#include <cmath>

#include "base/rt_safe.h"

namespace stanok::process {

struct Vibration {
  double amplitude_um = 0.0;  // a0; 0: within the dead zone
  double frequency_hz = 0.0;
};

class VibrationAmplifier {
 public:
  // Block 18: the permissible level, um; 0: nothing goes through.
  void set_level(double level_um) RT_SAFE {
    level_um_ = level_um;
    is_above_ = false;
  }
  [[nodiscard]] double level_um() const RT_SAFE { return level_um_; }

  // `release`: part of the level.
  [[nodiscard]] Vibration pass(const Vibration& sensed, double release) RT_SAFE {
    if (level_um_ <= 0.0 || !std::isfinite(sensed.amplitude_um)) return {};
    is_above_ = sensed.amplitude_um > (is_above_ ? release * level_um_ : level_um_);
    if (!is_above_) return {};
    const double excess = sensed.amplitude_um - level_um_;  // of block 17
    return {.amplitude_um = excess + level_um_, .frequency_hz = sensed.frequency_hz};
  }

 private:
  double level_um_ = 0.0;
  bool is_above_ = false;
};

}  // namespace stanok::process
