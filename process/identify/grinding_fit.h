// What the recorded power of a plunge cycle tells of machine and wheel: stiffness, cutting
// coefficient and exponent of the force law.
//
// The cycle is run again on the model of process/grinding with the recorded X, and the power of the
// wheel spindle is N_0 + L[g P], g being the watts of a newton of normal force, force ratio times
// wheel speed over efficiency, and L a lag of first order of the sensor. Steps of the feed tell the
// exponent, what decays in the spark-out tells the coefficient over the stiffness, the height of
// the power both, as g is given, the moment of the touch the lag. Each value has its interval of 95
// %. Off line.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/expected.h"
#include "process/grinding/grinding_process.h"
#include "process/identify/drive_fit.h"
#include "process/identify/fit_verdict.h"

namespace stanok::process {

struct GrindRow {
  double x_mm = 0.0;  // commanded; the part is touched at `allowance_mm`
  double power_w =
      std::numeric_limits<double>::quiet_NaN();  // a new reading at the end of the cycle
};

struct GrindRecord {
  double cycle_s = 0.001;
  double allowance_mm = 0.0;
  double watts_per_newton = 0.0;  // g
  std::vector<GrindRow> rows;
};

struct GrindingFit {
  Estimate stiffness_n_per_m;
  Estimate force_factor;  // C_p
  Estimate force_exponent;
  Estimate idle_w;
  Estimate lag_s;  // may be a cycle below 0: when in a cycle a value is read is not known
  double noise = 0.0;
  double residual_w = 0.0;
  std::vector<double> fitted_w;  // by row
  FitVerdict verdict;
};

// `sheet`: geometry, speed, mass and damping are taken as they are; stiffness and force law are
// where the search begins.
[[nodiscard]] Expected<GrindingFit, std::string> fit_grinding(const GrindRecord& record,
                                                              const GrindingProcess& sheet);

}  // namespace stanok::process
