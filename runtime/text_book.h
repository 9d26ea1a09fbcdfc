// TextBook: the program texts that were asked for, on their way from the preparations to the log.
#pragma once

#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "recording/format/encode_inputs.h"

namespace stanok::runtime {

class TextBook {
 public:
  // Any thread but the real-time one.
  void note(recording::ProgramRead read) {
    const std::lock_guard lock(mutex_);
    reads_.push_back(std::move(read));
    has_news_.store(true, std::memory_order_release);
  }

  // What came since the last call; cheap when there is nothing.
  [[nodiscard]] std::vector<recording::ProgramRead> take() {
    if (!has_news_.load(std::memory_order_acquire)) return {};
    const std::lock_guard lock(mutex_);
    has_news_.store(false, std::memory_order_relaxed);
    return std::exchange(reads_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<recording::ProgramRead> reads_;
  std::atomic<bool> has_news_{false};
};

}  // namespace stanok::runtime
