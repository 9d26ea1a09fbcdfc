#include "motion/feed_laws/linear_law.h"

#include <algorithm>

namespace stanok::motion {

LawStretch LinearLaw::stretch(std::uint64_t increments) const RT_SAFE {
  const std::uint64_t made = std::min(increments, parameters_.increments_max);
  const auto steps = static_cast<double>(made);
  LawStretch stretch;
  if (made < parameters_.increments_max) stretch.end_mm = (steps + 1.0) * parameters_.path_step_mm;
  stretch.feed = parameters_.feed_first + steps * parameters_.feed_step;
  stretch.speed = parameters_.speed_first + steps * parameters_.speed_step;
  return stretch;
}

std::uint64_t LinearLaw::increments_at(double path_mm) const RT_SAFE {
  return std::min(whole_steps(path_mm, parameters_.path_step_mm), parameters_.increments_max);
}

double LinearLaw::highest_feed(double path_mm) const {
  return std::max(parameters_.feed_first, stretch(increments_at(path_mm)).feed);
}

}  // namespace stanok::motion
