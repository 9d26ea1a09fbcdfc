#include "daemon/cycle/cycle_clock.h"

#include <cerrno>
#include <ctime>

namespace stanok::daemon {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

}  // namespace

std::int64_t MonotonicClock::now_ns() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * ns_per_s + time.tv_nsec;
}

void MonotonicClock::sleep_until(std::int64_t time_ns) {
  const timespec time{.tv_sec = time_ns / ns_per_s, .tv_nsec = time_ns % ns_per_s};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

}  // namespace stanok::daemon
