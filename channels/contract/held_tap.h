// HeldTap: a tap that was stopped in its hole, as far as it must be known to bring it out in step
// with its spindle.
#pragma once

#include <cstdint>

#include "motion/path/path.h"

namespace stanok::channels {

struct HeldTap {
  std::int32_t spindle = 0;   // index in the channel
  double lead_mm = 0.0;       // along its way
  double rev_per_min = 0.0;   // of the spindle on the way in, at 100 %, clockwise > 0
  motion::Point start_M{};    // where it left its rest
  motion::Point deepest_M{};  // of where it has been
};

}  // namespace stanok::channels
