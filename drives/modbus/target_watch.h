// TargetWatch: whether the cycle still writes targets.
//
// Owned by the bus, on its thread. Time is given by the caller, as the time since the start of the
// bus.
#pragma once

#include <cstdint>

#include "drives/modbus/contact_watch.h"

namespace stanok::drives {

enum class TargetAge : std::uint8_t { fresh, stale };

class TargetWatch {
 public:
  explicit TargetWatch(BusTime timeout) : timeout_(timeout) {}

  // `writes`: of the cycle so far.
  [[nodiscard]] TargetAge age(std::uint64_t writes, BusTime now) {
    if (writes != writes_seen_) {
      writes_seen_ = writes;
      last_write_ = now;
    }
    return now - last_write_ > timeout_ ? TargetAge::stale : TargetAge::fresh;
  }

 private:
  BusTime timeout_;
  std::uint64_t writes_seen_ = 0;
  BusTime last_write_{0};
};

}  // namespace stanok::drives
