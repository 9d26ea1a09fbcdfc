#include "daemon/cycle/real_time_loop.h"

#include <algorithm>

namespace stanok::daemon {
namespace {

constexpr std::int64_t statistics_period_ns = 100'000'000;

}  // namespace

RealTimeLoop::RealTimeLoop(CyclicWork& work, CycleClock& clock, std::int64_t period_ns)
    : work_(work),
      clock_(clock),
      period_ns_(period_ns),
      cycles_between_statistics_(std::max<std::int64_t>(1, statistics_period_ns / period_ns)) {}

void RealTimeLoop::run() {
  due_ns_ = clock_.now_ns() + period_ns_;
  while (!stopping_.load(std::memory_order_relaxed)) run_once();
  published_.write(statistics_);
}

void RealTimeLoop::run_once() {
  clock_.sleep_until(due_ns_);
  const std::int64_t woken_ns = clock_.now_ns();
  const std::int64_t lateness_ns = woken_ns - due_ns_;
  work_.cycle(leave_out_passed_wake_ups(woken_ns));
  const std::int64_t done_ns = clock_.now_ns();
  const CycleTimes times{.latency_ns = lateness_ns, .duration_ns = done_ns - woken_ns};
  statistics_.latency.add(times.latency_ns);
  statistics_.cycle_time.add(times.duration_ns);
  static_cast<void>(times_.push(times));
  ++statistics_.cycles;
  due_ns_ += period_ns_;
  if (statistics_.cycles % cycles_between_statistics_ == 0) published_.write(statistics_);
}

// Their number.
std::int64_t RealTimeLoop::leave_out_passed_wake_ups(std::int64_t now_ns) {
  const std::int64_t passed = std::max<std::int64_t>(0, (now_ns - due_ns_) / period_ns_);
  if (passed == 0) return 0;
  due_ns_ += passed * period_ns_;
  ++statistics_.overruns;
  statistics_.periods_skipped += passed;
  return passed;
}

}  // namespace stanok::daemon
