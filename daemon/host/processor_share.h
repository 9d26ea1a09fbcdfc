// ProcessorShare: a thread that others may flood uses a part of a processor at most.
//
// Asked between two pieces of work: when the thread has used up its time in the current window, it
// sleeps to the end of the window, or goes on without its priority. For threads with a priority
// before which all others wait.
#pragma once

#include <chrono>

namespace stanok::daemon {

class ProcessorShare {
 public:
  ProcessorShare(std::chrono::nanoseconds time, std::chrono::nanoseconds window)
      : time_(time), window_(window) {}

  void rest_when_used_up();
  // The time in the current window is used up; the next one begins by itself.
  [[nodiscard]] bool is_used_up();

 private:
  using Clock = std::chrono::steady_clock;
  std::chrono::nanoseconds time_;
  std::chrono::nanoseconds window_;
  Clock::time_point window_end_{};
  std::chrono::nanoseconds used_at_begin_{0};
};

}  // namespace stanok::daemon
