#include "motion/feed_laws/alternating_law.h"

#include <algorithm>

namespace stanok::motion {

LawStretch AlternatingLaw::stretch(std::uint64_t increments) const RT_SAFE {
  return {.end_mm = (static_cast<double>(increments) + 1.0) * parameters_.path_step_mm,
          .feed = increments % 2 == 0 ? parameters_.feed_min : parameters_.feed_max};
}

std::uint64_t AlternatingLaw::increments_at(double path_mm) const RT_SAFE {
  return whole_steps(path_mm, parameters_.path_step_mm);
}

double AlternatingLaw::highest_feed(double path_mm) const {
  const double first = parameters_.feed_min;
  return increments_at(path_mm) == 0 ? first : std::max(first, parameters_.feed_max);
}

}  // namespace stanok::motion
