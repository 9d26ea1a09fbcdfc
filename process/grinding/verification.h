// A cycle under test: its table is simulated and held against the boundary.
//
// Three faults are told apart. Above the burn line L(H) the surface burns. Above Q_max, but below
// L, the system is bent by more than is permitted: of no consequence while the removal builds up
// (plunge-in), a fault later. The size of the highest place at the end has a tolerance to both
// sides. The last layer is a spiral as high as the feed of a revolution: what of it the spark-out
// must leave is the roundness that is asked for.
#pragma once

#include <optional>
#include <vector>

#include "process/grinding/boundary.h"
#include "process/grinding/finding.h"
#include "process/grinding/plunge.h"

namespace stanok::process {

struct VerificationLimits {
  // How far above the burn line and Q_max the removal may come: they are an experiment's.
  double burn_margin = 0.05;
  double residual_max_mm = 0.001;   // left at the end: upper tolerance of the radius
  double undersize_max_mm = 0.001;  // taken too much: lower tolerance
  double roundness_max_mm = 0.0;    // out of round at the end; 0: nothing is asked for
};

// A greatest ratio along the cycle, and where it is.
struct Peak {
  double ratio = 0.0;
  double time_s = 0.0;
  double x_mm = 0.0;
};

// What the table does on a system that is `factor` as stiff as the sheet says.
struct SizeError {
  double factor = 1.0;
  double error_mm = 0.0;  // of the radius, against the sheet's stiffness; > 0: oversize
  // When the last feed goes on until a gauge finds the size on the whole circumference, s; none:
  // not within the time of the simulation.
  std::optional<double> gauged_time_s{};
};

struct Verification {
  PlungeRun run;
  Peak boundary;          // Q/D of the whole cycle
  Peak boundary_settled;  // Q/D behind the plunge-in
  Peak deflection;        // Q/Q_max behind the plunge-in
  Peak burn;              // Q/L
  std::vector<SizeError> size_errors;
  Findings findings;
};

// How many revolutions the wheel has to stand at the last X until the step of the spiral is as low
// as that; none: not within 40.
[[nodiscard]] std::optional<int> spark_out_needed(const GrindingProcess& process,
                                                  const InfeedLaw& law,
                                                  const PlungeOptions& simulation,
                                                  double roundness_mm);

[[nodiscard]] Verification verify_cycle(const GrindingProcess& process, const InfeedLaw& law,
                                        const PlungeOptions& simulation,
                                        const VerificationLimits& limits);

}  // namespace stanok::process
