// SelfOscillation: a tool or workpiece that begins to swing by itself in the cut, one degree of
// freedom after van der Pol.
//
//   m x'' - 2 d m w (1 - 4 x^2 / a^2) x' + m w^2 x = P(t)
// In the cut it swings up to the amplitude a at w; out of the cut the damping is positive. x counts
// from the static deflection: P is the force less its mean. A force of another frequency quenches
// it when it moves the mass by a / sqrt(2) or more. No damping is more than critical. Integrated by
// Runge-Kutta of fourth order.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"

namespace stanok::plant {

struct SelfOscillationConfig {
  double amplitude_um = 0.0;
  double frequency_hz = 100.0;
  double mass_kg = 1.0;
  double negative_damping = 0.05;  // d
};

enum class Engagement : std::uint8_t { out_of_cut, in_cut };

class SelfOscillation {
 public:
  explicit SelfOscillation(const SelfOscillationConfig& config) : config_(config) {}

  // `force_n`: less its mean.
  void advance(double force_n, Engagement engagement, double dt_s) RT_SAFE;
  [[nodiscard]] double displacement_um() const RT_SAFE { return x_um_; }

 private:
  [[nodiscard]] double acceleration(double x_um, double v, double force_n,
                                    Engagement engagement) const RT_SAFE;

  SelfOscillationConfig config_;
  double x_um_ = 0.01;  // a seed: at rest it would stay at rest
  double v_ = 0.0;      // um/s
};

}  // namespace stanok::plant
