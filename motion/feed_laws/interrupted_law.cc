#include "motion/feed_laws/interrupted_law.h"

namespace stanok::motion {

LawStretch InterruptedLaw::stretch(std::uint64_t increments) const RT_SAFE {
  return {.end_mm = (static_cast<double>(increments) + 1.0) * cut_mm_, .stand_mm = stand_mm_};
}

std::uint64_t InterruptedLaw::increments_at(double path_mm) const RT_SAFE {
  return whole_steps(path_mm, cut_mm_);
}

}  // namespace stanok::motion
