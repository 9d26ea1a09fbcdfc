// Interrupted feed: a real path L_B at the programmed feed, then an equivalent dwell path L_A at
// the same feed, during which the axes stand, and so on.
#pragma once

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

class InterruptedLaw final : public FeedLaw {
 public:
  // L_A and L_B in mm, both > 0.
  InterruptedLaw(double stand_mm, double cut_mm)
      : FeedLaw({}), stand_mm_(stand_mm), cut_mm_(cut_mm) {}

  [[nodiscard]] LawKind kind() const RT_SAFE override { return LawKind::interrupted; }
  [[nodiscard]] LawStretch stretch(std::uint64_t increments) const RT_SAFE override;
  [[nodiscard]] std::uint64_t increments_at(double path_mm) const RT_SAFE override;
  [[nodiscard]] double highest_feed(double) const override { return 0.0; }
  [[nodiscard]] double stand_mm() const { return stand_mm_; }
  [[nodiscard]] double cut_mm() const { return cut_mm_; }

 private:
  double stand_mm_;
  double cut_mm_;
};

}  // namespace stanok::motion
