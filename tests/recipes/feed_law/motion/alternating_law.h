// Alternating feed along the path: dl at Smin, dl at Smax, and so on.
#pragma once

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

struct AlternatingLawParameters {
  double feed_min = 0.0;
  double feed_max = 0.0;
  double path_step_mm = 0.0;  // dl > 0
};

class AlternatingLaw final : public FeedLaw {
 public:
  AlternatingLaw(const LawUnits& units, const AlternatingLawParameters& parameters)
      : FeedLaw(units), parameters_(parameters) {}

  [[nodiscard]] LawKind kind() const RT_SAFE override { return LawKind::alternating; }
  [[nodiscard]] LawStretch stretch(std::uint64_t increments) const RT_SAFE override;
  [[nodiscard]] std::uint64_t increments_at(double path_mm) const RT_SAFE override;
  [[nodiscard]] double highest_feed(double path_mm) const override;

 private:
  AlternatingLawParameters parameters_;
};

}  // namespace stanok::motion
