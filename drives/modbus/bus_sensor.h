// BusSensor: a vibration sensor on a bus: what is read, when, and what crosses to the cycle.
//
// A sensor that does not answer is left alone for the timeout. The bus thread owns it; only
// `take_samples` and `level` belong to the cycle, through a ring and a box whose place must not
// change.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/latest.h"
#include "base/ring.h"
#include "base/rt_safe.h"
#include "drives/bus.h"
#include "drives/modbus/contact_watch.h"
#include "drives/modbus/patience.h"
#include "drives/modbus/signal_exchange.h"
#include "drives/vibration.h"
#include "drives/vibration_meter.h"

namespace stanok::drives {

class BusSensor {
 public:
  // `drive`: that turns its spindle, by its place on the bus; none: no drive tells the speed.
  BusSensor(const VibrationSensorConfig& config, BusTime timeout,
            std::optional<std::size_t> drive = std::nullopt);

  [[nodiscard]] bool is_due(BusTime now) const { return now >= again_at_; }
  [[nodiscard]] SignalBlock& block() { return block_; }
  [[nodiscard]] Patience& patience() { return patience_; }
  [[nodiscard]] std::optional<std::size_t> drive() const { return drive_; }
  // The block has been read, with the spindle at this speed.
  void take(double rev_per_min = 0.0);
  void fail(BusTime now);

  // All but the name.
  void tell(VibrationStatus& status) const;

  // The cycle's: the new samples in um, the oldest first, as many as there is room for.
  [[nodiscard]] std::size_t take_samples(std::span<double> samples_um) RT_SAFE;
  // The cycle's: what the meter says; not a number while the sensor does not answer.
  [[nodiscard]] VibrationLevel level() RT_SAFE { return level_.read(); }

 private:
  SignalBlock block_;
  VibrationReader reader_;
  VibrationMeter meter_;
  Ring<double> samples_;
  Latest<VibrationLevel> level_;
  std::uint64_t errors_ = 0;
  BusTime timeout_;
  std::optional<std::size_t> drive_;
  Patience patience_;
  BusTime again_at_{0};  // after a try that failed
};

}  // namespace stanok::drives
