#include "process/grinding/stability.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "process/grinding/force_law.h"

namespace stanok::process {
namespace {

double stiffness_of_thinnest_layer(const GrindingProcess& process) {
  const double layer_mm = process.removal_end_mm2_per_rad / removal_radius_mm(process);
  return ForceLaw(process).cutting_stiffness_n_per_mm(layer_mm);
}

}  // namespace

double stability_margin(const GrindingProcess& process) {
  const double zeta = damping_ratio(process);
  const double limit_n_per_mm = 2.0 * process.stiffness_n_per_m / 1000.0 * zeta * (1.0 + zeta);
  return limit_n_per_mm / stiffness_of_thinnest_layer(process);
}

// A wave that comes n times in a revolution tau, e^(s t), is met again as e^(s tau) times itself:
// (C + b s + m s²) / k = e^(-s tau) - 1. Its s is the root of f(s) = s tau + ln(1 + R(s)/k) - 2 pi
// n i with R the resistance on the left; Newton's method from the s of a wave that stays. Counted
// between a fifth of the natural frequency and ten times it: others die out faster.
double wave_growth(const GrindingProcess& process) {
  constexpr double lowest = 0.2;
  constexpr double highest = 10.0;
  constexpr int waves_max = 100'000;  // of more, neighbours grow alike: some are left out
  constexpr int rounds_max = 30;
  constexpr double settled = 1e-12;                                // of s tau
  const double k = 1000.0 * stiffness_of_thinnest_layer(process);  // N/m
  const double natural = std::sqrt(process.stiffness_n_per_m / process.mass_kg);
  const double turn_s = revolution_s(process);
  const double natural_waves = natural * turn_s / (2.0 * std::numbers::pi);
  const double first = std::max(1.0, std::floor(lowest * natural_waves));
  const double span = std::max(0.0, highest * natural_waves + 1.0 - first);
  const double every = std::max(1.0, std::ceil(span / waves_max));
  const int waves = static_cast<int>(span / every) + 1;
  double greatest = 0.0;
  for (int i = 0; i < waves; ++i) {
    const double n = first + every * i;
    const std::complex<double> turned(0.0, 2.0 * std::numbers::pi * n);
    std::complex<double> s = turned / turn_s;
    for (int round = 0; round < rounds_max; ++round) {
      const std::complex<double> whole =
          k + process.stiffness_n_per_m + process.damping_n_s_per_m * s + process.mass_kg * s * s;
      const std::complex<double> slope =
          turn_s + (process.damping_n_s_per_m + 2.0 * process.mass_kg * s) / whole;
      const std::complex<double> step = (s * turn_s + std::log(whole / k) - turned) / slope;
      s -= step;
      if (std::abs(step) * turn_s < settled) break;
    }
    greatest = std::max(greatest, std::exp(s.real() * turn_s));
  }
  return greatest;
}

}  // namespace stanok::process
