// FaultReset: one demand of the cycle resets one fault of a drive; a fault that comes again stays.
//
// Owned by the exchange of one axis, on the bus thread.
#pragma once

#include "base/rt_safe.h"
#include "drives/drive.h"

namespace stanok::drives {

class FaultReset {
 public:
  // Before each command: whether the cycle demands it, and the state that the drive was last seen
  // in.
  void look(const DriveTarget& target, DriveState state) RT_SAFE {
    if (target.fault_reset && !demanded_) pending_ = true;
    pending_ = pending_ && target.fault_reset && state == DriveState::fault;
    demanded_ = target.fault_reset;
  }
  // The drive is to be told so now.
  [[nodiscard]] bool is_pending() const RT_SAFE { return pending_; }

 private:
  bool demanded_ = false;
  bool pending_ = false;
};

}  // namespace stanok::drives
