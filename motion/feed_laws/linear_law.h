// Linear feed along the path: S_n, and an increment of dS after every |dl|; with or without
// increments of the spindle's speed at the same places.
//
// Stretch k = 0, 1, 2, ... runs at S_n + k dS (dS signed), up to a last increment if there is one:
// S_k = S_n + N dS. Both speeds may change in different directions, and dS may be 0.
#pragma once

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

struct LinearLawParameters {
  double feed_first = 0.0;    // S_n
  double feed_step = 0.0;     // dS, signed
  double path_step_mm = 0.0;  // |dl| > 0
  std::uint64_t increments_max = ~std::uint64_t{0};
  double speed_first = 0.0;  // n_n, v_n; 0: unchanged
  double speed_step = 0.0;   // dn, dv, signed
};

class LinearLaw final : public FeedLaw {
 public:
  LinearLaw(const LawUnits& units, const LinearLawParameters& parameters)
      : FeedLaw(units), parameters_(parameters) {}

  [[nodiscard]] LawKind kind() const RT_SAFE override { return LawKind::linear; }
  [[nodiscard]] LawStretch stretch(std::uint64_t increments) const RT_SAFE override;
  [[nodiscard]] std::uint64_t increments_at(double path_mm) const RT_SAFE override;
  [[nodiscard]] double highest_feed(double path_mm) const override;
  [[nodiscard]] const LinearLawParameters& parameters() const { return parameters_; }

 private:
  LinearLawParameters parameters_;
};

}  // namespace stanok::motion
