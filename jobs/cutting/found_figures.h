// What was found in the log of a cut, as the text of a file that other functions read.
#pragma once

#include <string>

#include "process/identify/grinding_fit.h"
#include "process/identify/milling_fit.h"
#include "process/identify/turning_fit.h"

namespace stanok::jobs {

// Of a quantity that is known over the one that was found.
[[nodiscard]] process::Estimate quotient(double known, const process::Estimate& found);

// [process] of a machine file, as far as the log tells it, each value with its interval.
// `rev_per_min`: the greatest of the record. `coefficient_n`: C of the material, which tells the
// efficiency; 0: it is not known.
[[nodiscard]] std::string process_section(const process::TurningFit& fit, double rev_per_min,
                                          double coefficient_n);

// The text of a process file with stiffness, force_factor and force_exponent replaced, each with
// its interval; all else stays.
[[nodiscard]] std::string with_figures(const std::string& process_file,
                                       const process::GrindingFit& fit);

// Forces of the cut out of those that the drive saw.
struct CutForces {
  process::Estimate force_n_per_mm2;
  process::Estimate edge_n_per_mm;
};
[[nodiscard]] CutForces cut_forces(const process::MillingFit& fit, double efficiency);

// The text of a file of tool and material (config/files/chatter_file.h) with force and edge_force
// replaced, each with its interval; all else stays.
[[nodiscard]] std::string with_figures(const std::string& cut_file, const CutForces& forces);

}  // namespace stanok::jobs
