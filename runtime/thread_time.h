// How long the processor has worked for the thread that asks: what a busy computer keeps it waiting
// does not count.
#pragma once

#include <time.h>

#include <chrono>

namespace stanok::runtime {

[[nodiscard]] inline std::chrono::nanoseconds processor_time_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace stanok::runtime
