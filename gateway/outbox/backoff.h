// Backoff: how long a thread waits before it tries again what failed: from half a second on, twice
// as long each time, sixteen seconds at most. A request to stop ends a wait at once.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace stanok::gateway {

inline void wait_for(std::chrono::milliseconds time, const std::stop_token& stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  never.wait_for(lock, stop, time, [] { return false; });
}

class Backoff {
 public:
  void wait(const std::stop_token& stop) {
    wait_for(time_, stop);
    time_ = std::min(2 * time_, longest);
  }
  void reset() { time_ = first; }
  [[nodiscard]] bool is_first() const { return time_ == first; }

 private:
  static constexpr std::chrono::milliseconds first{500};
  static constexpr std::chrono::milliseconds longest{16000};
  std::chrono::milliseconds time_ = first;
};

}  // namespace stanok::gateway
