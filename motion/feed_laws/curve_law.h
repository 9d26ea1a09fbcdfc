// A curve of feeds over the path, approximated by linear laws.
//
// Between two points of the curve the feed goes in increments of one size, the last one smaller, at
// places as far apart as the slope wants, rounded to increments of the machine; the speed of the
// spindle goes along in as many increments. Behind the last point its values hold.
#pragma once

#include <vector>

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

struct CurveLawPoint {
  double path_mm = 0.0;  // ascending from 0
  double feed = 0.0;
  double speed = 0.0;
};

class CurveLaw final : public FeedLaw {
 public:
  // `feed_step`: the machine's smallest increment of feed; `increment_mm`: of path.
  CurveLaw(const LawUnits& units, const std::vector<CurveLawPoint>& points, double feed_step,
           double increment_mm);

  [[nodiscard]] LawKind kind() const RT_SAFE override { return LawKind::curve; }
  [[nodiscard]] LawStretch stretch(std::uint64_t increments) const RT_SAFE override;
  [[nodiscard]] std::uint64_t increments_at(double path_mm) const RT_SAFE override;
  [[nodiscard]] double highest_feed(double path_mm) const override;

 private:
  void add_line(const CurveLawPoint& from, const CurveLawPoint& to, double feed_step,
                double increment_mm);

  std::vector<LawStretch> stretches_;
};

}  // namespace stanok::motion
