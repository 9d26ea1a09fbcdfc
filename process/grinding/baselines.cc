#include "process/grinding/baselines.h"

#include <algorithm>

#include "process/grinding/boundary.h"
#include "process/grinding/force_law.h"
#include "process/grinding/staircase.h"

namespace stanok::process {
namespace {

// The removal is nearly proportional to the feed: each round leaves a hundredth of the error.
constexpr int scaling_rounds = 5;

InfeedLaw three_step_law(const GrindingProcess& process, double allowance_mm, double last_feed) {
  const std::vector<Step> steps{{allowance_mm, 4.0 * last_feed},
                                {0.30 * allowance_mm, 2.0 * last_feed},
                                {0.12 * allowance_mm, last_feed}};
  return law_of_steps(steps, -overrun_max_mm(process));
}

double peak_ratio(const GrindingProcess& process, const PlungeRun& run) {
  const Boundary boundary(process);
  double peak = 0.0;
  for (const PlungeSample& sample : run.samples) {
    peak = std::max(peak, sample.removal_mm2_per_rad / boundary.at(sample.allowance_mm));
  }
  return peak;
}

}  // namespace

double constant_safe_time_s(const GrindingProcess& process, double allowance_mm) {
  const double removal = process.removal_end_mm2_per_rad;
  const double deflection_mm =
      ForceLaw(process).force_n(removal) / (process.stiffness_n_per_m / 1000.0);
  const double layer_mm = removal / removal_radius_mm(process);
  return (allowance_mm + deflection_mm + layer_mm) / steady_feed_mm_per_s(process, removal);
}

double three_step_time_s(const GrindingProcess& process, double allowance_mm,
                         const PlungeOptions& simulation) {
  PlungeOptions options = simulation;
  options.at_end = InfeedTravel::AtEnd::goes_on;
  double feed = steady_feed_mm_per_s(process, process.removal_end_mm2_per_rad);
  PlungeRun run;
  for (int round = 0; round < scaling_rounds; ++round) {
    run = simulate_plunge(process, three_step_law(process, allowance_mm, feed), options);
    feed /= peak_ratio(process, run);
  }
  return run.time_s;
}

}  // namespace stanok::process
