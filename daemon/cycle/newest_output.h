// NewestOutput: the output of the newest cycle for everybody who asks, without a way through the
// recorder, which may be late.
//
// One slot belongs to the cycle, one to the readers, and the third one changes hands between them:
// neither waits for the other. Invariant: the three indices are 0, 1 and 2 in some order.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "base/rt_safe.h"
#include "channels/contract/output.h"
#include "drives/modbus/bus_clock.h"

namespace stanok::daemon {

class NewestOutput {
 public:
  // What is told before the first cycle.
  explicit NewestOutput(const channels::CycleOutput& first);

  // The cycle's thread.
  void put(const channels::CycleOutput& output) RT_SAFE;
  // All other threads.
  [[nodiscard]] channels::CycleOutput get();
  // How long ago it was put.
  [[nodiscard]] std::chrono::nanoseconds age() const {
    return clock_.now() - put_at_.load(std::memory_order_relaxed);
  }

 private:
  static constexpr unsigned is_new = 4;  // beside the index of the slot between both
  static constexpr unsigned index_mask = 3;

  std::unique_ptr<std::array<channels::CycleOutput, 3>> slots_;
  unsigned written_ = 0;
  std::atomic<unsigned> between_{1};
  drives::BusClock clock_;
  std::atomic<drives::BusTime> put_at_{clock_.now()};
  std::mutex readers_;
  unsigned read_ = 2;
};

}  // namespace stanok::daemon
