#include "channels/machine/input_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stanok::channels {

void InputWatch::take(std::int64_t cycle, const Signals* signals,
                      std::span<const SpindleSensors> sensors) RT_SAFE {
  using enum SpindleQuantity;
  cycle_ = cycle;
  Signals next;
  if (looped_outputs_ != nullptr) next = *looped_outputs_;
  if (signals != nullptr) next = *signals;
  if (next != signals_) take(next);
  const NumberedSpan<const SpindleSensors> given = sensors;
  for (int k = 0; std::cmp_less(k, std::min(given.size(), sensors_.size())); ++k) {
    take(k, power_w, given[k].power_w, sensors_[k].power_w);
    take(k, vibration_um, given[k].vibration_um, sensors_[k].vibration_um);
    take(k, vibration_hz, given[k].vibration_hz, sensors_[k].vibration_hz);
  }
}

void InputWatch::take(const Signals& next) RT_SAFE {
  for (int k = 0; k < Signals::digital_count; ++k) {
    if (next.is_on(k) == signals_.is_on(k)) continue;
    books_.inputs.note(
        {.cycle = cycle_, .content = DigitalInput{.number = k, .is_on = next.is_on(k)}});
  }
  for (int k = 0; k < Signals::analog_count; ++k) {
    if (next.analog[k] == signals_.analog[k]) continue;
    books_.changes.note(
        {.cycle = cycle_, .content = AnalogInput{.number = k, .value = next.analog[k]}});
  }
  signals_ = next;
}

// NaN tells that there is no value: it is no change from NaN.
void InputWatch::take(int spindle, SpindleQuantity quantity, double given, double& kept) RT_SAFE {
  if (given == kept || (std::isnan(given) && std::isnan(kept))) return;
  kept = given;
  books_.changes.note(
      {.cycle = cycle_,
       .content = SpindleInput{.spindle = spindle, .quantity = quantity, .value = given}});
}

}  // namespace stanok::channels
