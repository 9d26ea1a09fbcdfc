#include "process/adaptive/quenching_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::process {
namespace {

// An amplitude stays within this part of itself; a law begins when it has stayed so long, or was
// above the level so long.
constexpr double steady_within = 0.03;
constexpr double steady_to_begin_s = 0.5;
// As the tool enters, the system bends, which a block of the meter shows as a vibration.
constexpr double entry_s = 1.2;
constexpr double above_to_begin_s = 1.5;
// A steady vibration under a steady force; longer than the block of the meter.
constexpr double steady_to_follow_s = 0.8;

// Of the amplitude without the force: below it the vibration has died out.
constexpr double quenched_part = 0.1;
// Under the force it has fallen by more than the meter is uncertain.
constexpr double fallen_part = 0.9;
constexpr double quiet_hold_s = 2.0;
// Of the force, a second, when it begins to fall, and how much faster with each second.
constexpr double fading_per_s = 0.01;
constexpr double fading_growth_per_s = 0.1;

// Another frequency by more than this part is another vibration; the force's own line is as close.
constexpr double same_frequency = 0.05;

bool is_near(double frequency_hz, double other_hz) RT_SAFE {
  return std::abs(frequency_hz - other_hz) <= same_frequency * other_hz;
}

}  // namespace

void QuenchingLaw::set(double mass_kg, double frequency_hz) RT_SAFE {
  mass_kg_ = mass_kg;
  frequency_hz_ = frequency_hz;
  forget();
}

void QuenchingLaw::forget() RT_SAFE {
  self_ = {};
  steady_ = {};
  above_s_ = quiet_s_ = 0.0;
  response_ = Response::not_seen;
}

void QuenchingLaw::take(const Vibration& vibration, Response response) RT_SAFE {
  self_ = vibration;
  response_ = response;
}

Oscillation QuenchingLaw::wanted(double revolution_s) const RT_SAFE {
  if (!is_on()) return {};
  const double formable_hz = formable_frequency(frequency_hz_, revolution_s);
  return {.force_n = reserve_ * quenching_force_n(self_, mass_kg_, formable_hz),
          .frequency_hz = frequency_hz_};
}

void QuenchingLaw::advance(const Inputs& inputs) RT_SAFE {
  cutting_s_ = inputs.cuts ? cutting_s_ + inputs.cycle_s : 0.0;
  if (!inputs.cuts || !can_form()) return forget();
  if (cutting_s_ < entry_s) return;
  is_on() ? follow(inputs) : begin(inputs);
}

void QuenchingLaw::watch_steadiness(const Vibration& vibration, double force_n, double cycle_s)
    RT_SAFE {
  const bool stays = std::abs(vibration.amplitude_um - steady_.amplitude_um) <=
                         steady_within * steady_.amplitude_um &&
                     std::abs(force_n - steady_.force_n) <= steady_within * steady_.force_n;
  if (stays) {
    steady_.s += cycle_s;
  } else {
    steady_ = {.amplitude_um = vibration.amplitude_um, .force_n = force_n};
  }
}

void QuenchingLaw::begin(const Inputs& inputs) RT_SAFE {
  const bool is_above = inputs.above.amplitude_um > 0.0;
  above_s_ = is_above ? above_s_ + inputs.cycle_s : 0.0;
  watch_steadiness(inputs.above, 0.0, inputs.cycle_s);
  if (!is_above || !(inputs.above.frequency_hz > 0.0)) return;
  if (steady_.s < steady_to_begin_s && above_s_ < above_to_begin_s) return;
  take(inputs.above, Response::not_seen);
  steady_ = {};
}

// B, um: by which the force moves the mass.
double QuenchingLaw::moved_um(const Oscillation& formed) const RT_SAFE {
  constexpr double um_per_m = 1e6;
  constexpr double turn = 2.0 * std::numbers::pi;
  const double self_w = turn * self_.frequency_hz;
  const double w = turn * formed.frequency_hz;
  const double stiffness = mass_kg_ * std::abs(self_w * self_w - w * w);
  return stiffness > 0.0 ? um_per_m * formed.force_n / stiffness : 0.0;
}

// Van der Pol: a^2 = a_0^2 - 2 B^2.
void QuenchingLaw::meet(const Vibration& now, const Oscillation& formed) RT_SAFE {
  const double moved = moved_um(formed);
  self_ = {.amplitude_um = std::hypot(now.amplitude_um, std::numbers::sqrt2 * moved),
           .frequency_hz = now.frequency_hz};
  steady_ = {};
}

void QuenchingLaw::follow(const Inputs& inputs) RT_SAFE {
  const Vibration& now = inputs.sensed;
  if (!std::isfinite(now.amplitude_um) || !std::isfinite(now.frequency_hz)) return;
  const bool is_own_line =
      inputs.formed.force_n > 0.0 && is_near(now.frequency_hz, inputs.formed.frequency_hz);
  // Another line begins to count above its level, as the first one did.
  const bool is_other = !is_near(now.frequency_hz, self_.frequency_hz);
  const bool is_within_level = is_other && inputs.above.amplitude_um == 0.0;
  const bool has_died_out = now.amplitude_um < quenched_part * self_.amplitude_um;
  if (is_own_line || is_within_level || has_died_out) return fade(inputs);
  // What comes back when the force has fallen is met at once: it grows on otherwise.
  const bool comes_back = quiet_s_ > quiet_hold_s;
  quiet_s_ = 0.0;
  if (comes_back && !is_other) return meet(now, inputs.formed);
  watch_steadiness(now, inputs.formed.force_n, inputs.cycle_s);
  if (steady_.s < steady_to_follow_s) return;
  steady_ = {};
  if (is_other) return take(now, Response::not_seen);
  const bool has_fallen = now.amplitude_um < fallen_part * self_.amplitude_um;
  if (response_ == Response::not_seen) response_ = has_fallen ? Response::falls : Response::none;
  if (response_ == Response::falls) {
    meet(now, inputs.formed);
  } else if (now.amplitude_um < inputs.least_um) {
    forget();
  } else {
    const bool has_grown = now.amplitude_um > self_.amplitude_um / fallen_part;
    take(now, has_grown ? Response::not_seen : Response::none);
  }
}

void QuenchingLaw::fade(const Inputs& inputs) RT_SAFE {
  steady_ = {};
  quiet_s_ += inputs.cycle_s;
  response_ = Response::falls;
  const double fading_s = quiet_s_ - quiet_hold_s;
  if (fading_s <= 0.0) return;
  const double per_s = fading_per_s * (1.0 + fading_growth_per_s * fading_s);
  self_.amplitude_um *= std::exp(-per_s * inputs.cycle_s);
  if (self_.amplitude_um < inputs.least_um) forget();
}

}  // namespace stanok::process
