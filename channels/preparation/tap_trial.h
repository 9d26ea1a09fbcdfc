// A rigid tap tried beforehand: whether the axes can follow an ideal spindle into the hole and out
// of it, by the same rules as in the cycle.
//
// What a tap needs is known only from its whole course: the axes catch the spindle up on the way
// in, it comes to rest at the bottom within what the thread leaves, and turns back.
#pragma once

#include "channels/contract/machine_config.h"
#include "motion/threads/thread_builder.h"

namespace stanok::channels {

struct TapTrial {
  const SpindleConfig& spindle;
  const motion::ThreadChain& chain;  // of the tap
  double cycle_s = 0.001;

  // At this speed; false: the axes lose the spindle. What takes longer than some minutes is taken
  // to be slow enough.
  [[nodiscard]] bool succeeds_at(double rev_per_min) const;
  // A speed below this one at which it succeeds, the highest but for some per cent; 0: none.
  [[nodiscard]] double fastest_below(double rev_per_min) const;
};

}  // namespace stanok::channels
