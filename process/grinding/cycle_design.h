// The design of a plunge cycle from the sheet of its process: continuous optimum, staircase for the
// control, its verification, and what it is compared with.
#pragma once

#include "base/expected.h"
#include "process/grinding/finding.h"
#include "process/grinding/optimiser.h"
#include "process/grinding/staircase.h"
#include "process/grinding/verification.h"

namespace stanok::process {

// The feed range where the sheet names none: from a tenth of the steady feed at Q_end to 1.3 times
// that at Q_max, which only the plunge-in can use.
[[nodiscard]] FeedRange usual_feeds(const GrindingProcess& process);

// What else is computed for a cycle: the continuous law and the three-step cycle, or nothing, for
// studies of many designs.
enum class Comparison { full, none };

// The length of the spark-out: as `simulation` has it, or the least that `roundness_max` needs.
enum class SparkOut { given, found };

struct DesignRequest {
  GrindingProcess process;
  double allowance_mm = 0.0;  // per side
  FeedRange feeds;            // 0, 0: the usual ones
  OptimiserOptions optimiser;
  StaircaseOptions staircase;
  PlungeOptions simulation{.time_max_s = 600.0};
  VerificationLimits limits;
  Comparison comparison = Comparison::full;
  SparkOut spark_out = SparkOut::given;
};

// A cycle and what it is worth.
struct CycleDesign {
  InfeedLaw law;
  double spark_out_revolutions = 0.0;
  Verification verification;
  double least_time_s = 0.0;
  double constant_safe_time_s = 0.0;
  OptimalLaw continuous;           // without rows: not compared
  double three_step_time_s = 0.0;  // 0: not compared
};

// What is refused before anything is simulated: numbers outside their ranges or against each other,
// switch points that do not fall, a gain of 1 or more (unless `stops_when_growing` is off), an
// allowance that takes longer than the time allowed whatever the feed.
[[nodiscard]] Findings request_findings(const DesignRequest& request);

// A design, or the reasons why there is none. A design may have findings of its own
// (`verification`).
[[nodiscard]] Expected<CycleDesign, Findings> design_cycle(const DesignRequest& request);

// Designs with a law that is given, as by a control file. A process that chatters is not
// compared.
[[nodiscard]] CycleDesign assessed_cycle(const DesignRequest& request, InfeedLaw law);

}  // namespace stanok::process
