#include "motion/feed_laws/curve_law.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
CurveLaw::CurveLaw(const LawUnits& units, const std::vector<CurveLawPoint>& points,
                   double feed_step, double increment_mm)
    : FeedLaw(units) {
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    add_line(points[k], points[k + 1], feed_step, increment_mm);
  const CurveLawPoint& last = points.back();
  stretches_.push_back({.end_mm = unlimited, .feed = last.feed, .speed = last.speed});
}

// Stretches from one point of the curve to the next. Where the path has no room for increments of
// the size asked for, one at each increment of the machine, they are larger.
void CurveLaw::add_line(const CurveLawPoint& from, const CurveLawPoint& to, double feed_step,
                        double increment_mm) {
  const double length = to.path_mm - from.path_mm;
  const double change =
      std::max(std::abs(to.feed - from.feed) / feed_step, std::abs(to.speed - from.speed));
  const double room = std::max(std::floor(length / increment_mm + same_path_mm), 1.0);
  const double step = std::max(1.0 / std::max(change, 1.0), 1.0 / room);  // share of the line
  for (double k = 0.0, done = 0.0; done < 1.0; k += 1.0) {
    const double next = (k + 1.0) * step;
    const bool last = next >= 1.0 - same_path_mm;
    const double end =
        last ? to.path_mm : from.path_mm + increment_mm * std::round(next * length / increment_mm);
    stretches_.push_back({.end_mm = end,
                          .feed = from.feed + (to.feed - from.feed) * done,
                          .speed = from.speed + (to.speed - from.speed) * done});
    done = last ? 1.0 : next;
  }
}

LawStretch CurveLaw::stretch(std::uint64_t increments) const RT_SAFE {
  return stretches_[std::min<std::uint64_t>(increments, stretches_.size() - 1)];
}

std::uint64_t CurveLaw::increments_at(double path_mm) const RT_SAFE {
  const auto next = std::upper_bound(
      stretches_.begin(), stretches_.end(), path_mm + same_path_mm,
      [](double place, const LawStretch& stretch) { return place < stretch.end_mm; });
  return static_cast<std::uint64_t>(next - stretches_.begin());
}

double CurveLaw::highest_feed(double path_mm) const {
  double highest = 0.0;
  for (std::uint64_t k = 0; k <= increments_at(path_mm); ++k)
    highest = std::max(highest, stretches_[k].feed);
  return highest;
}

}  // namespace stanok::motion
