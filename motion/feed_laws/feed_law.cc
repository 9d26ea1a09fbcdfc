#include "motion/feed_laws/feed_law.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {

std::uint64_t whole_steps(double path_mm, double step_mm) RT_SAFE {
  return static_cast<std::uint64_t>(std::max(0.0, std::floor((path_mm + same_path_mm) / step_mm)));
}

}  // namespace stanok::motion
