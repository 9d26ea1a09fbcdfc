// RealTimeLoop: calls the machine's cycle once per period, at absolute times.
//
// Wake-up k is due at start + k periods, whatever happened before; latenesses do not add up. Where
// the clock wakes it a whole period late or more, or the cycle before took so long, the wake-ups
// that have passed are left out and counted, and the cycle is told how many they were. What a cycle
// does is the affair of CyclicWork, which allocates, locks and waits for nothing
// (docs/integrator/realtime.md).
#pragma once

#include <atomic>
#include <cstdint>

#include "base/histogram.h"
#include "base/latest.h"
#include "base/ring.h"
#include "base/rt_safe.h"
#include "daemon/cycle/cycle_clock.h"

namespace stanok::daemon {

class CyclicWork {
 public:
  CyclicWork() = default;
  virtual ~CyclicWork() = default;
  CyclicWork(const CyclicWork&) = delete;
  CyclicWork& operator=(const CyclicWork&) = delete;

  // Read the process image, update all channels, write setpoints. `lost`: periods that have passed
  // without a cycle before this one.
  virtual void cycle(std::int64_t lost) RT_SAFE = 0;
};

struct LoopStatistics {
  std::int64_t cycles = 0;
  std::int64_t overruns = 0;
  std::int64_t periods_skipped = 0;
  Histogram latency;     // from the time due to the wake-up, ns
  Histogram cycle_time;  // from the wake-up to the end of the cycle, ns
};

// Of one cycle.
struct CycleTimes {
  std::int64_t latency_ns = 0;   // from the time due to the wake-up
  std::int64_t duration_ns = 0;  // from the wake-up to the end of the cycle
};

class RealTimeLoop {
 public:
  // `work` and `clock` outlive the loop.
  RealTimeLoop(CyclicWork& work, CycleClock& clock, std::int64_t period_ns);

  // Returns after `stop`.
  void run();
  // Any thread, signal handlers too.
  void stop() { stopping_.store(true, std::memory_order_relaxed); }

  // Statistics of at most 100 ms ago. One reader thread.
  [[nodiscard]] const LoopStatistics& statistics() { return published_.read(); }
  // The times of every cycle, for one reader thread; those that find no room are lost.
  [[nodiscard]] Ring<CycleTimes>& times() { return times_; }

 private:
  void run_once();
  [[nodiscard]] std::int64_t leave_out_passed_wake_ups(std::int64_t now_ns);

  CyclicWork& work_;
  CycleClock& clock_;
  std::int64_t period_ns_;
  std::int64_t cycles_between_statistics_;
  std::int64_t due_ns_ = 0;
  LoopStatistics statistics_;
  Latest<LoopStatistics> published_;
  Ring<CycleTimes> times_{1024};
  std::atomic<bool> stopping_{false};
};

}  // namespace stanok::daemon
