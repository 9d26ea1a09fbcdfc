// The course of a plunge cycle as pictures, the protocol and Python show it.
#pragma once

#include <vector>

#include "jobs/columns/columns.h"
#include "process/grinding/cycle_design.h"

namespace stanok::jobs {

struct GrindingSample {
  process::PlungeSample plunge;
  double removal_ratio = 0.0;  // removal over its boundary D(H)
};

[[nodiscard]] std::vector<GrindingSample> grinding_samples(const process::GrindingProcess& process,
                                                           const process::PlungeRun& run);

// time_s, x_mm, allowance_mm, feed_mm_per_s, removal_mm2_per_rad, removal_ratio, deflection_mm.
[[nodiscard]] const Columns<GrindingSample>& grinding_columns();

// The first six, which pictures and process.grinding show.
[[nodiscard]] Columns<GrindingSample> grinding_overview();

}  // namespace stanok::jobs
