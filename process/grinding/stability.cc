#include "process/grinding/stability.h"

#include <algorithm>
#include <cmath>
#include <complex>

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

// The waves of all frequencies between a fifth of the natural one and ten times it: others die
// out faster.
double wave_growth(const GrindingProcess& process) {
  constexpr int waves = 4000;
  constexpr double lowest = 0.2;
  constexpr double highest = 10.0;
  constexpr int rounds = 4;  // of the growth within one period, which is little
  const double k = 1000.0 * stiffness_of_thinnest_layer(process);  // N/m
  const double natural = std::sqrt(process.stiffness_n_per_m / process.mass_kg);
  const double turn_s = revolution_s(process);
  double greatest = 0.0;
  for (int n = 0; n <= waves; ++n) {
    const double w = natural * lowest * std::pow(highest / lowest, static_cast<double>(n) / waves);
    double growth = 1.0;
    for (int round = 0; round < rounds; ++round) {
      const std::complex<double> s(std::log(growth) / turn_s, w);
      const std::complex<double> resistance =
          process.stiffness_n_per_m + process.damping_n_s_per_m * s + process.mass_kg * s * s;
      growth = 1.0 / std::abs(1.0 + resistance / k);
    }
    greatest = std::max(greatest, growth);
  }
  return greatest;
}

}  // namespace stanok::process
