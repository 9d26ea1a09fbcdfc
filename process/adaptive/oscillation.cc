#include "process/adaptive/oscillation.h"

#include <cmath>
#include <numbers>

namespace stanok::process {
namespace {

using std::numbers::pi;

// Closer to a multiple of the spindle's frequency, in parts of it, an oscillation is moved away.
constexpr double distance_min = 0.15;

}  // namespace

double quenching_force_n(const Vibration& self_oscillation, double mass_kg, double frequency_hz)
    RT_SAFE {
  constexpr double m_per_um = 1e-6;
  const double omega_d = 2.0 * pi * self_oscillation.frequency_hz;
  const double omega = 2.0 * pi * frequency_hz;
  return self_oscillation.amplitude_um * m_per_um / std::numbers::sqrt2 * mass_kg *
         std::abs(omega_d * omega_d - omega * omega);
}

double chip_part(double frequency_hz, double revolution_s) RT_SAFE {
  const double x = pi * frequency_hz * revolution_s;
  return x == 0.0 ? 1.0 : std::abs(std::sin(x) / x);
}

double formable_frequency(double frequency_hz, double revolution_s) RT_SAFE {
  const double turns = frequency_hz * revolution_s;
  const double multiple = std::round(turns);
  if (multiple < 1.0 || std::abs(turns - multiple) >= distance_min) return frequency_hz;
  return (turns < multiple ? multiple - 0.5 : multiple + 0.5) / revolution_s;
}

}  // namespace stanok::process
