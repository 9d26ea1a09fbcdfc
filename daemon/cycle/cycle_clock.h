// The clock of the real-time loop: monotonic, so that a jump of the wall clock changes nothing.
#pragma once

#include <cstdint>

namespace stanok::daemon {

class CycleClock {
 public:
  CycleClock() = default;
  virtual ~CycleClock() = default;
  CycleClock(const CycleClock&) = delete;
  CycleClock& operator=(const CycleClock&) = delete;

  [[nodiscard]] virtual std::int64_t now_ns() = 0;
  // Returns at or after the absolute time; at once when it has passed.
  virtual void sleep_until(std::int64_t time_ns) = 0;
};

// CLOCK_MONOTONIC with clock_nanosleep.
class MonotonicClock final : public CycleClock {
 public:
  [[nodiscard]] std::int64_t now_ns() override;
  void sleep_until(std::int64_t time_ns) override;
};

}  // namespace stanok::daemon
