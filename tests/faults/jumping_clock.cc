// Preloaded: the wall clock goes back and forth by a day with every look at it; clocks that only go
// forward are left alone.
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  constexpr time_t day = 86400;
  static std::atomic<int> looks{0};
  const long outcome = syscall(SYS_clock_gettime, clock, time);
  if (outcome == 0 && clock == CLOCK_REALTIME) time->tv_sec += ++looks % 2 == 0 ? day : -day;
  return static_cast<int>(outcome);
}
