#include "motion/feed_laws/modulated_law.h"

#include <algorithm>

namespace stanok::motion {

LawStretch ModulatedLaw::stretch(std::uint64_t increments) const RT_SAFE {
  const std::uint64_t in_cycle = increments % (2 * parameters_.steps);
  const std::uint64_t above_min = std::min(in_cycle, 2 * parameters_.steps - in_cycle);
  return {.end_mm = (static_cast<double>(increments) + 1.0) * parameters_.path_step_mm,
          .feed = parameters_.feed_min + static_cast<double>(above_min) * parameters_.feed_step};
}

std::uint64_t ModulatedLaw::increments_at(double path_mm) const RT_SAFE {
  return whole_steps(path_mm, parameters_.path_step_mm);
}

double ModulatedLaw::highest_feed(double path_mm) const {
  const std::uint64_t up = std::min(increments_at(path_mm), parameters_.steps);
  return parameters_.feed_min + static_cast<double>(up) * parameters_.feed_step;
}

}  // namespace stanok::motion
