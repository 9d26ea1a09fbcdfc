// BusClock: the time since the start of a bus. Any thread.
#pragma once

#include <chrono>

#include "drives/modbus/contact_watch.h"

namespace stanok::drives {

class BusClock {
 public:
  [[nodiscard]] BusTime now() const { return std::chrono::steady_clock::now() - epoch_; }
  [[nodiscard]] std::chrono::steady_clock::time_point at(BusTime time) const {
    return epoch_ + time;
  }

 private:
  std::chrono::steady_clock::time_point epoch_ = std::chrono::steady_clock::now();
};

}  // namespace stanok::drives
