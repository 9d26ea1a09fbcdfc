// What a recorded turning cut tells of spindle drive and material: idle power over speed, cutting
// coefficient and exponent, lag of the power sensor.
//
//   N_d = a n + b n^2 + L[ (C / eta) t h^y w R ]
// t: depth of cut; h: the way of the tool over the last turn. Steps of depth and feed tell C/eta
// and y, their edges the lag, the power out of the cut at several speeds a and b
// (process/identify/drive_fit.h). The coefficient and the efficiency come only as their quotient:
// the power does not tell them apart. Off line.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/expected.h"
#include "process/identify/drive_fit.h"

namespace stanok::process {

// One cycle of a cut.
struct CutRow {
  double rev_per_min = 0.0;
  double radius_mm = 0.0;
  double depth_mm = 0.0;         // 0: out of the cut
  double travel_mm = 0.0;        // at working feed
  double z_mm = 0.0;             // of the tool, in the frame of the stock
  double hardness_factor = 1.0;  // of the force there, over that of the hardness for which C is
  // As the sensor showed it at the end of the cycle; not a number: it has shown nothing new.
  double power_w = std::numeric_limits<double>::quiet_NaN();
};

struct CutRecord {
  double cycle_s = 0.001;
  std::vector<CutRow> rows;
};

struct TurningFit : DriveFit {
  Estimate coefficient_n;  // C / eta, N: depth 1 mm, 1 mm per turn
  Estimate exponent;       // y
};

// Or what the record lacks.
[[nodiscard]] Expected<TurningFit, std::string> fit_turning(const CutRecord& record);

}  // namespace stanok::process
