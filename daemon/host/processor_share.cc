#include "daemon/host/processor_share.h"

#include <ctime>
#include <thread>

namespace stanok::daemon {
namespace {

std::chrono::nanoseconds processor_time_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

bool ProcessorShare::is_used_up() {
  const auto now = Clock::now();
  const auto used = processor_time_of_thread();
  if (now >= window_end_) {
    window_end_ = now + window_;
    used_at_begin_ = used;
  }
  return used - used_at_begin_ >= time_;
}

void ProcessorShare::rest_when_used_up() {
  if (is_used_up()) std::this_thread::sleep_until(window_end_);
}

}  // namespace stanok::daemon
