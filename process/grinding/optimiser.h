// The continuous infeed law whose removal follows the boundary: iteration like a closed loop.
//
// Each iteration simulates the law V_i(H_z) and takes the error e = D(H_f) - Q along the cycle.
// Error and command belong together at one instant: H_f, the allowance left under the wheel, and
// H_z = X, what is commanded, differ by the deflection. The next law is
//
//   V_{i+1}(H_z) = clip(V_i + k_oc e / (R_eq tau), V_min, V_max)
//
// Source: Petrakov 2014, figure 6; k_oc is the paper's coefficient of feedback. A gain k_oc < 1
// shrinks the error of slow changes by 1 - k_oc each time; above 1 it swings, and from 2 on it
// grows. Changes within a revolution lag behind the command by half a revolution and more, so that
// there the error grows in the end whatever the gain is: the iteration stops then and keeps its
// best law.
#pragma once

#include <functional>
#include <vector>

#include "process/grinding/boundary.h"
#include "process/grinding/plunge.h"

namespace stanok::process {

struct FeedRange {
  double min_mm_per_s = 0.0;
  double max_mm_per_s = 0.0;
};

struct Iteration {
  int number = 0;      // from 0, the constant feed
  double rms = 0.0;    // of 1 - Q/D behind the plunge-in
  double worst = 0.0;  // largest |1 - Q/D| there
};

enum class Settling { converged, grew, ran_out };

struct OptimiserOptions {
  double feedback = 0.5;  // k_oc > 0
  int iterations_max = 40;
  bool stops_when_growing = true;  // false: to study an unstable gain
  // Told each iteration as it ends.
  std::function<void(const Iteration&)> on_iteration{};
};

struct OptimalLaw {
  InfeedLaw law;  // the best of all iterations
  PlungeRun run;  // what it does
  Iteration best;
  std::vector<Iteration> iterations;
  Settling settling = Settling::ran_out;
};

// `options` of the simulation: its end is always where the size is reached.
[[nodiscard]] OptimalLaw optimal_law(const GrindingProcess& process, double allowance_mm,
                                     const FeedRange& feeds, const OptimiserOptions& options,
                                     const PlungeOptions& simulation);

}  // namespace stanok::process
