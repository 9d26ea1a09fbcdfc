// InputWatch: the signals and the sensor values that a cycle sees; what changes is written down.
//
// Thread: the real-time cycle. Owner: the machine. Invariant: signals that are off and 0, sensors
// that tell nothing, and the records since then give what a cycle saw.
#pragma once

#include <cstdint>
#include <span>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "base/signals.h"
#include "channels/contract/output.h"
#include "channels/stores/change_book.h"
#include "channels/stores/input_book.h"

namespace stanok::channels {

// Where what changes is written down: digital signals; all that may change in each cycle.
struct WatchBooks {
  InputBook& inputs;
  ChangeBook& changes;
};

class InputWatch {
 public:
  // Sensors of as many spindles. `looped_outputs`: seen as inputs where none are given; nullptr:
  // they are not. It and the books outlive the watch.
  InputWatch(std::size_t spindle_count, const Signals* looped_outputs, const WatchBooks& books)
      : looped_outputs_(looped_outputs), books_(books), sensors_(spindle_count) {}

  // Once a cycle. `signals`: nullptr: none are given. `sensors`: in the order of the machine's
  // spindles; of those behind its end the values stay.
  void take(std::int64_t cycle, const Signals* signals, std::span<const SpindleSensors> sensors)
      RT_SAFE;

  [[nodiscard]] const Signals& signals() const RT_SAFE { return signals_; }
  [[nodiscard]] NumberedSpan<const SpindleSensors> sensors() const RT_SAFE { return sensors_; }

 private:
  void take(const Signals& next) RT_SAFE;
  void take(int spindle, SpindleQuantity quantity, double given, double& kept) RT_SAFE;

  const Signals* looped_outputs_;
  WatchBooks books_;
  Signals signals_;
  NumberedList<SpindleSensors> sensors_;
  std::int64_t cycle_ = 0;
};

}  // namespace stanok::channels
