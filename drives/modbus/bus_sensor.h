// BusSensor: a vibration sensor on a bus: what is read, when, and what crosses to the cycle.
//
// A sensor that does not answer is left alone for the timeout. The bus thread owns it; only
// `take_samples` belongs to the cycle, through a ring whose place must not change.
#pragma once

#include <cstdint>
#include <span>

#include "base/ring.h"
#include "base/rt_safe.h"
#include "drives/bus.h"
#include "drives/modbus/contact_watch.h"
#include "drives/modbus/patience.h"
#include "drives/modbus/signal_exchange.h"
#include "drives/vibration.h"

namespace stanok::drives {

class BusSensor {
 public:
  BusSensor(const VibrationSensorConfig& config, BusTime timeout);

  [[nodiscard]] bool is_due(BusTime now) const { return now >= again_at_; }
  [[nodiscard]] SignalBlock& block() { return block_; }
  [[nodiscard]] Patience& patience() { return patience_; }
  // The block has been read.
  void take();
  void fail(BusTime now);

  // All but the name.
  void tell(VibrationStatus& status) const;

  // The cycle's: the new samples in um, the oldest first, as many as there is room for.
  [[nodiscard]] std::size_t take_samples(std::span<double> samples_um) RT_SAFE;

 private:
  SignalBlock block_;
  VibrationReader reader_;
  VibrationMeter meter_;
  Ring<double> samples_;
  std::uint64_t errors_ = 0;
  BusTime timeout_;
  Patience patience_;
  BusTime again_at_{0};  // after a try that failed
};

}  // namespace stanok::drives
