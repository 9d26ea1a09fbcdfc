// ClockGaps: what periods that passed without a cycle mean for the path.
//
// A drive goes on with its last velocity for a while. For so long the clock of the path goes on,
// too: the cycles of the periods that have passed are made up for, and what the drive is told next
// is where the path is now. Up to `catch_up_max` periods that is all; behind more of them the path
// comes to rest, since it left its curve meanwhile.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/rt_safe.h"
#include "channels/contract/clock_gap.h"
#include "channels/contract/machine_config.h"
#include "channels/machine/machine.h"
#include "drives/drive.h"

namespace stanok::runtime {

class ClockGaps {
 public:
  explicit ClockGaps(const channels::MachineConfig& machine)
      : catch_up_max_(machine.catch_up_max),
        bridged_(std::llround(1e6 * drives::bridged_s / machine.cycle_us)) {}

  // The gap before the next cycle of `machine`.
  [[nodiscard]] channels::ClockGap gap_of(std::int64_t periods,
                                          const channels::Machine& machine) const RT_SAFE {
    return {.periods = periods,
            .then = behind(periods),
            .carried = machine.may_carry_on() ? std::min(periods, bridged_) : 0};
  }

 private:
  [[nodiscard]] channels::AfterGap behind(std::int64_t periods) const RT_SAFE {
    using channels::AfterGap;
    if (periods > bridged_) return AfterGap::is_held;
    return periods > catch_up_max_ ? AfterGap::rests : AfterGap::goes_on;
  }

  std::int64_t catch_up_max_;
  std::int64_t bridged_;
};

}  // namespace stanok::runtime
