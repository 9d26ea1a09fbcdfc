// The speed that a spindle has under constant cutting speed, G96, as the cycle gives it
// (Spindle::follow_diameter and target), without an override.
#pragma once

#include <algorithm>
#include <numbers>

namespace stanok::channels {

// rev/min.
struct SpindleRange {
  double min = 0.0;
  double max = 0.0;
  double limit = 0.0;  // of G96, D; 0: none
};

// n = 1000 v / (pi D), rev/min, within the range; v in m/min, D in mm. At the centre the range
// gives it.
[[nodiscard]] inline double speed_of_cut(const SpindleRange& range, double m_per_min,
                                         double diameter_mm) {
  constexpr double mm_per_m = 1000.0;
  const double highest = range.limit > 0.0 ? std::min(range.limit, range.max) : range.max;
  const double wanted = mm_per_m * m_per_min / (std::numbers::pi * diameter_mm);
  return std::max(range.min, std::min(wanted, highest));
}

}  // namespace stanok::channels
