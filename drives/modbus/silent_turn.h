// SilentTurn: which of the drives that were given up is tried next.
//
// They take turns, one a timeout: every try costs the others the time of an answer that does not
// come. Owned by the bus, on its thread. Time is given by the caller.
#pragma once

#include <cstddef>

#include "drives/modbus/contact_watch.h"

namespace stanok::drives {

class SilentTurn {
 public:
  explicit SilentTurn(BusTime timeout) : timeout_(timeout) {}

  // Goes on to the next of `drives` of which `is_lost(drive)` holds, if there is one.
  template <class IsLost>
  void choose(std::size_t drives, const IsLost& is_lost) {
    for (std::size_t step = 1; step <= drives; ++step) {
      const std::size_t drive = (drive_ + step) % drives;
      if (is_lost(drive)) {
        drive_ = drive;
        return;
      }
    }
  }
  [[nodiscard]] bool is_turn_of(std::size_t drive, BusTime now) const {
    return drive == drive_ && now >= again_at_;
  }
  void note_silence(BusTime now) { again_at_ = now + timeout_; }

 private:
  BusTime timeout_;
  std::size_t drive_ = 0;
  BusTime again_at_{0};
};

}  // namespace stanok::drives
