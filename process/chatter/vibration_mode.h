// VibrationMode: one natural vibration of tool, spindle or part, as a hammer test or a modal
// analysis finds it.
//
// Receptance of a mode at the frequency omega (J. Tlusty, Manufacturing Processes and Equipment,
// 2000, ch. 7): G = (1 / k) / (1 - r^2 + 2 i zeta r), r = omega / omega_n. Modes of one direction
// add.
#pragma once

#include <complex>
#include <numbers>
#include <span>

namespace stanok::process {

struct VibrationMode {
  static constexpr int count_max = 8;  // of a cut

  double frequency_hz = 0.0;  // natural, undamped
  double damping = 0.0;       // ratio zeta, above 0
  double stiffness_n_per_mm = 0.0;

  [[nodiscard]] double omega() const { return 2.0 * std::numbers::pi * frequency_hz; }
};

// mm/N at omega, rad/s.
[[nodiscard]] inline std::complex<double> receptance(std::span<const VibrationMode> modes,
                                                     double omega) {
  std::complex<double> sum;
  for (const VibrationMode& mode : modes) {
    const double r = omega / mode.omega();
    sum +=
        1.0 / (mode.stiffness_n_per_mm * std::complex<double>(1.0 - r * r, 2.0 * mode.damping * r));
  }
  return sum;
}

}  // namespace stanok::process
