// CycleBoxes: what crosses between the real-time cycle and the thread of a bus: the newest target
// and feedback of each drive, and the signals.
//
// The cycle never waits: each value is in a latest-value box. Feedback older than the timeout is
// invalid even when the bus thread itself hangs; that is counted in cycles, where it is read.
// Two threads, each with its own functions: the cycle and the bus thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "base/latest.h"
#include "base/rt_safe.h"
#include "base/units.h"
#include "drives/drive.h"
#include "drives/modbus/contact_watch.h"
#include "drives/signals.h"

namespace stanok::drives {

class CycleBoxes {
 public:
  // `cycle`: period of `write` and `read`.
  CycleBoxes(std::size_t drives, Duration timeout, Duration cycle);

  // The cycle's. Drives that are not there are passed over.
  // Its targets are for the end of the cycle that began `now`.
  void write(std::span<const DriveTarget> targets, BusTime now) RT_SAFE;
  void read(std::span<DriveFeedback> feedback) RT_SAFE;
  void write_signals(const Signals& outputs) RT_SAFE { outputs_.write(outputs); }
  [[nodiscard]] Signals read_signals() RT_SAFE { return inputs_.read(); }

  // The bus thread's.
  // The newest one; where the cycle is late, carried on to `now`.
  [[nodiscard]] DriveTarget target(std::size_t drive, BusTime now);
  void publish(std::size_t drive, const DriveFeedback& feedback) {
    boxes_[drive].feedback.write(feedback);
  }
  [[nodiscard]] Signals outputs() { return outputs_.read(); }
  void publish_inputs(const Signals& inputs) { inputs_.write(inputs); }
  // How often the cycle has written targets so far.
  [[nodiscard]] std::uint64_t writes() const { return writes_.load(std::memory_order_relaxed); }

 private:
  struct TimedTarget {
    DriveTarget target;
    BusTime due{0};
  };
  struct Boxes {
    Latest<TimedTarget> target;
    Latest<DriveFeedback> feedback;
    std::uint32_t sequence_seen = 0;  // of the cycle
    std::uint32_t age_cycles = 0;
  };

  std::vector<Boxes> boxes_;
  BusTime cycle_;
  std::uint32_t timeout_cycles_;
  Latest<Signals> outputs_;
  Latest<Signals> inputs_;
  std::atomic<std::uint64_t> writes_{0};
};

}  // namespace stanok::drives
