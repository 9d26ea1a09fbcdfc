// A plunge cycle that is designed or assessed: the job behind `stanok grind design` and `verify`
// and their functions of Python.
//
// `optimiser.on_iteration` of the request is told of the progress; what it throws ends the job.
#pragma once

#include <string>
#include <vector>

#include "base/fields.h"
#include "jobs/grinding/grind_input.h"
#include "process/grinding/robust_design.h"

namespace stanok::jobs {

struct GrindCycle {
  process::DesignRequest request;
  process::CycleDesign design;
  std::vector<process::Corner> corners;  // of a robust design
};

// A table that works for all of `spread`, or why it is refused.
[[nodiscard]] Expected<GrindCycle, process::Findings> designed_cycle(
    const process::DesignRequest& request, const process::Spread& spread);

// The table of a control file, which may take an hour.
[[nodiscard]] GrindCycle assessed_cycle(process::DesignRequest request,
                                        const process::InfeedLaw& law);

// The control file with the law of the cycle; labels and decimals as they were in `input`.
[[nodiscard]] std::string control_text(const GrindInput& input, const GrindCycle& cycle);

// Nothing: not computed, or not reached.
[[nodiscard]] std::optional<double> three_step_time_s(const process::CycleDesign& design);
[[nodiscard]] std::optional<double> continuous_time_s(const process::CycleDesign& design);

[[nodiscard]] Fields cycle_fields(const GrindCycle& cycle);
// ok and findings, of a request that was refused.
[[nodiscard]] Fields refusal_fields(const process::Findings& findings);
// A law on the elastic system.
[[nodiscard]] Fields plunge_fields(const process::PlungeRun& run);

}  // namespace stanok::jobs
