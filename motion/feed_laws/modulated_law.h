// Modulated feed: from Smin in n_s increments of dS up to Smax = Smin + n_s dS, in as many down
// again, and so on; an increment after every dl of path.
#pragma once

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

struct ModulatedLawParameters {
  double feed_min = 0.0;      // Smin
  double feed_step = 0.0;     // dS > 0
  double path_step_mm = 0.0;  // dl > 0
  std::uint64_t steps = 1;    // n_s
};

class ModulatedLaw final : public FeedLaw {
 public:
  ModulatedLaw(const LawUnits& units, const ModulatedLawParameters& parameters)
      : FeedLaw(units), parameters_(parameters) {}

  [[nodiscard]] LawKind kind() const RT_SAFE override { return LawKind::modulated; }
  [[nodiscard]] LawStretch stretch(std::uint64_t increments) const RT_SAFE override;
  [[nodiscard]] std::uint64_t increments_at(double path_mm) const RT_SAFE override;
  [[nodiscard]] double highest_feed(double path_mm) const override;
  [[nodiscard]] const ModulatedLawParameters& parameters() const { return parameters_; }

 private:
  ModulatedLawParameters parameters_;
};

}  // namespace stanok::motion
