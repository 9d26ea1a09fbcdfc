// BusClock: the time since the start of a bus. Any thread.
#pragma once

#include <chrono>

#include "base/rt_safe.h"
#include "drives/modbus/contact_watch.h"

namespace stanok::drives {

// The clock is read without the kernel, as the real-time loop reads it.
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wfunction-effects"
#endif
class BusClock {
 public:
  [[nodiscard]] BusTime now() const RT_SAFE { return std::chrono::steady_clock::now() - epoch_; }
  [[nodiscard]] std::chrono::steady_clock::time_point at(BusTime time) const {
    return epoch_ + time;
  }

 private:
  std::chrono::steady_clock::time_point epoch_ = std::chrono::steady_clock::now();
};
#if defined(__clang__)
#pragma clang diagnostic pop
#endif

}  // namespace stanok::drives
