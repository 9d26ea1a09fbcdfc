#include "process/adaptive/setpoint_law.h"

#include <cmath>
#include <numbers>

#include "process/adaptive/oscillation.h"

namespace stanok::process {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

// The feed swings by no more than this part of itself: it must not come to rest.
constexpr double feed_swing_max = 0.9;

}  // namespace

void SetpointLaw::set_programmed(const Oscillation& oscillation) RT_SAFE {
  programmed_ = oscillation;
  was_shifted_ = was_limited_ = false;
}

void SetpointLaw::set_automatic(double mass_kg, double frequency_hz) RT_SAFE {
  quenching_.set(mass_kg, frequency_hz);
  was_shifted_ = was_limited_ = false;
}

ForceSetpoint SetpointLaw::advance(const Inputs& inputs) RT_SAFE {
  event_ = motion::ForceEvent::none;
  const bool was_on = quenching_.is_on();
  quenching_.advance({.cycle_s = inputs.cycle_s,
                      .revolution_s = inputs.revolution_s,
                      .above = inputs.vibration,
                      .sensed = inputs.sensed,
                      .least_um = inputs.least_um,
                      .formed = formed_,
                      .cuts = inputs.cuts});
  if (quenching_.is_on() && !was_on) phase_ = 0.0;
  form(quenching_.is_on() ? quenching_.wanted(inputs.revolution_s) : programmed_,
       inputs.revolution_s);
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
