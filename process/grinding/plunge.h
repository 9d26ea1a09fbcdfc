// Simulation of a plunge cycle: an elastic system, a cut with the delay of one revolution.
//
//   m y'' + b y' + C y = P            y: the wheel gives way by y
//   p = (X_0 - X) - y                 how deep the wheel stands in the original surface
//   a = max(0, p - s(t - tau))        the layer taken now; s: depth of the surface at this angle,
//   P = C_p B (Q V)^alpha             left one revolution ago
//
// y is integrated with the average acceleration (Newmark, 1959, beta = 1/4, gamma = 1/2), stable
// for any step; the force at the end of the step belongs to the y at its end, so that each step
// solves one monotone scalar equation. The surface is a ring of a whole number of steps: the delay
// is exact. Source: docs/programmer/grinding.md, "The model".
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "process/grinding/grinding_process.h"
#include "process/grinding/infeed_law.h"

namespace stanok::process {

struct PlungeOptions {
  double time_step_max_s = 0.0005;
  InfeedTravel::AtEnd at_end = InfeedTravel::AtEnd::stands;
  // Revolutions for which the wheel stands at the end of the law (spark-out).
  double spark_out_revolutions = 0.0;
  // A cycle that takes longer is given up, s.
  double time_max_s = 3600.0;
  // Rate of wear of the wheel in mm/s at a removal Q in mm2/rad; none: it does not wear.
  std::function<double(double)> wear_rate_mm_per_s{};
};

// The state of the cut at the end of a time step.
struct PlungeSample {
  double time_s = 0.0;
  double x_mm = 0.0;                 // H_z, commanded
  double allowance_mm = 0.0;         // H_f, left under the wheel
  double feed_mm_per_s = 0.0;        // commanded
  double removal_mm2_per_rad = 0.0;  // Q
  double deflection_mm = 0.0;        // y
};

struct PlungeRun {
  std::vector<PlungeSample> samples;
  double time_s = 0.0;                   // of the whole cycle, spark-out included
  std::optional<double> size_reached_s;  // when nothing was left anywhere on the circumference
  double residual_mm = 0.0;              // the most that is left anywhere, at the end
  double residual_min_mm = 0.0;          // the least
  double residual_mean_mm = 0.0;         // on the average over the circumference
  double wear_mm = 0.0;                  // of the wheel
  double volume_mm2 = 0.0;               // integral of Q over the angle: area of what was taken
  int contact_losses = 0;  // how often the wheel left the part while fed, behind the plunge-in
  double force_max_n = 0.0;

  // Of the radius over the circumference: the step of the spiral that the last layer is.
  [[nodiscard]] double out_of_roundness_mm() const { return residual_mm - residual_min_mm; }
};

// Runs the law from the touch. With `goes_on` the run ends when the size is reached, else with the
// law and its spark-out; after time_max_s at the latest.
[[nodiscard]] PlungeRun simulate_plunge(const GrindingProcess& process, const InfeedLaw& law,
                                        const PlungeOptions& options);

}  // namespace stanok::process
