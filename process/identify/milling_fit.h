// What a recorded milling cut tells of spindle drive and material: idle power over speed, force
// coefficients, lag of the power sensor.
//
//   N_d = a n + b n^2 + L[ (K_t Q + K_te E) / eta ]
// Q: volume that is cut per second; E: area over which edges rub per second, their length in the
// cut times the cutting speed. This is the mean over a tooth of the tangential force K_t h + K_te
// of a unit of edge (Y. Altintas, Manufacturing Automation, 2nd ed. 2012, ch. 2.5) times the
// cutting speed. The quotient Q / E is the mean thickness of the chip: cuts of several tell the two
// apart. The drive's part is that of process/identify/drive_fit.h. Radial forces do no work: the
// power does not tell them. Off line.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/expected.h"
#include "process/identify/drive_fit.h"

namespace stanok::process {

// One cycle of a cut.
struct MillingRow {
  double rev_per_min = 0.0;
  double removal_mm3_per_s = 0.0;  // Q
  double rubbing_mm2_per_s = 0.0;  // E
  // As the sensor showed it at the end of the cycle; not a number: it has shown nothing new.
  double power_w = std::numeric_limits<double>::quiet_NaN();
};

struct MillingRecord {
  double cycle_s = 0.001;
  std::vector<MillingRow> rows;
};

struct MillingFit : DriveFit {
  Estimate force_n_per_mm2;  // K_t / eta
  Estimate edge_n_per_mm;    // K_te / eta
};

// Or what the record lacks.
[[nodiscard]] Expected<MillingFit, std::string> fit_milling(const MillingRecord& record);

}  // namespace stanok::process
