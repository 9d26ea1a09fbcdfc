#include "process/adaptive/setpoint_law.h"

#include <cmath>
#include <numbers>

#include "process/adaptive/oscillation.h"

namespace stanok::process {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

// The amplitude of a self-oscillation has settled when it stays this close for this long.
constexpr double settled_within = 0.03;
constexpr double settling_s = 0.3;

// The feed swings by no more than this part of itself: it must not come to rest.
constexpr double feed_swing_max = 0.9;

}  // namespace

void SetpointLaw::set_programmed(const Oscillation& oscillation) RT_SAFE {
  programmed_ = oscillation;
  was_shifted_ = was_limited_ = false;
}

void SetpointLaw::set_automatic(double mass_kg, double frequency_hz) RT_SAFE {
  mass_kg_ = mass_kg;
  automatic_hz_ = frequency_hz;
  has_automatic_ = false;
  settled_s_ = 0.0;
  was_shifted_ = was_limited_ = false;
}

ForceSetpoint SetpointLaw::advance(const Inputs& inputs) RT_SAFE {
  event_ = motion::ForceEvent::none;
  watch(inputs);
  form(has_automatic_ ? automatic_ : programmed_, inputs.revolution_s);
  if (formed_.force_n <= 0.0 || !inputs.cuts) return {mean_n_, mean_n_, mean_n_, mean_n_};
  phase_ = std::fmod(phase_ + full_turn * formed_.frequency_hz * inputs.cycle_s, full_turn);
  const double swing = formed_.force_n * std::sin(phase_);
  return {.mean_n = mean_n_,
          .now_n = mean_n_ + swing,
          .sensed_n = mean_n_ + sensed_swing(inputs.revolution_s),
          .emphasised_n = mean_n_ + emphasis_ * swing};
}

// The mean over a revolution comes half a revolution late, beyond each multiple of the spindle's
// frequency with the other sign; the lag of the sensor takes its part of phase and amplitude.
double SetpointLaw::sensed_swing(double revolution_s) const RT_SAFE {
  const double turn_angle = 0.5 * full_turn * formed_.frequency_hz * revolution_s;
  const double sign = std::sin(turn_angle) < 0.0 ? -1.0 : 1.0;
  const double lag = std::atan(full_turn * formed_.frequency_hz * config_.power_lag_s);
  return sign * formed_.force_n * std::cos(lag) * std::sin(phase_ - turn_angle - lag);
}

// Forms the automatic oscillation once, from a vibration that has settled above its level.
void SetpointLaw::watch(const Inputs& inputs) RT_SAFE {
  if (!inputs.cuts || !can_form()) {
    has_automatic_ = false;
    settled_s_ = 0.0;
    return;
  }
  if (has_automatic_) return;
  const Vibration& vibration = inputs.vibration;
  const bool stays =
      vibration.amplitude_um > 0.0 && std::abs(vibration.amplitude_um - settling_.amplitude_um) <=
                                          settled_within * settling_.amplitude_um;
  settled_s_ = stays ? settled_s_ + inputs.cycle_s : 0.0;
  if (!stays) settling_ = vibration;
  if (settled_s_ < settling_s) return;
  const double frequency = formable_frequency(automatic_hz_, inputs.revolution_s);
  automatic_ = {
      .force_n = config_.oscillation_reserve * quenching_force_n(vibration, mass_kg_, frequency),
      .frequency_hz = automatic_hz_};
  has_automatic_ = true;
  phase_ = 0.0;
}

// What can be formed of the oscillation at this speed of the spindle.
void SetpointLaw::form(const Oscillation& wanted, double revolution_s) RT_SAFE {
  formed_ = {};
  if (wanted.force_n <= 0.0 || mean_n_ <= 0.0) return;
  formed_.frequency_hz = formable_frequency(wanted.frequency_hz, revolution_s);
  const double lag = full_turn * formed_.frequency_hz * config_.feed_lag_s;
  emphasis_ = std::sqrt(1.0 + lag * lag) /
              (config_.feed_exponent * chip_part(formed_.frequency_hz, revolution_s));
  const double force_max = feed_swing_max * mean_n_ / emphasis_;
  formed_.force_n = std::fmin(wanted.force_n, force_max);
  if (formed_.frequency_hz != wanted.frequency_hz && !was_shifted_) {
    was_shifted_ = true;
    event_ = motion::ForceEvent::frequency_shifted;
  } else if (formed_.force_n < wanted.force_n && !was_limited_) {
    was_limited_ = true;
    event_ = motion::ForceEvent::oscillation_limited;
  }
}

}  // namespace stanok::process
