// Refill: where the path ends in the cut because its preparation came too late, the axes rest until
// enough of it is known, so that they rest seldom and not with each piece that comes.
//
// Thread: the real-time cycle. Owner: the channel. What it looks at is what the cycle is shown of
// the queue, so that a replay rests alike.
#pragma once

#include "base/rt_safe.h"
#include "motion/interpolation/interpolator.h"
#include "motion/path/path_queue.h"

namespace stanok::channels {

class Refill {
 public:
  // Once a cycle. True: it begins now.
  [[nodiscard]] bool look(motion::PathState state, const motion::PathQueue& queue) RT_SAFE;
  // No path, no rest: a run begins, or what there was is dropped.
  void forget() RT_SAFE { is_on_ = false; }

  [[nodiscard]] bool is_on() const RT_SAFE { return is_on_; }

 private:
  bool is_on_ = false;
};

}  // namespace stanok::channels
