// What a recorded cut tells of spindle drive and material: idle power over speed, cutting
// coefficient and exponent, lag of the power sensor.
//
//   N_d = a n + b n^2 + L[ (C / eta) t h^y w R ]
// t: depth of cut; h: the way of the tool over the last turn; L: a lag of first order. Steps of
// depth and feed tell C/eta and y, their edges the lag, the power out of the cut at several speeds
// a and b. The coefficient and the efficiency come only as their quotient: the power does not tell
// them apart. Each value has the interval in which it lies with 95 % probability, if the noise of
// one reading does not depend on that of the one before. Off line.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"

namespace stanok::process {

// One cycle of a cut.
struct CutRow {
  double rev_per_min = 0.0;
  double radius_mm = 0.0;
  double depth_mm = 0.0;   // 0: out of the cut
  double travel_mm = 0.0;  // at working feed
  // As the sensor showed it at the end of the cycle; not a number: it has shown nothing new.
  double power_w = std::numeric_limits<double>::quiet_NaN();
};

struct CutRecord {
  double cycle_s = 0.001;
  std::vector<CutRow> rows;
};

struct Estimate {
  double value = 0.0;
  double low = 0.0;  // the interval
  double high = 0.0;

  [[nodiscard]] double half_width() const { return 0.5 * (high - low); }
};

struct TurningFit {
  Estimate idle_linear;                 // a, W per rev/min
  std::optional<Estimate> idle_square;  // b; none: the record has one speed only
  Estimate coefficient_n;               // C / eta, N: depth 1 mm, 1 mm per turn
  Estimate exponent;                    // y
  Estimate lag_s;
  double noise = 0.0;       // of the cutting power, standard deviation
  double residual_w = 0.0;  // rms
  int readings = 0;
  std::vector<double> fitted_w;  // by row

  [[nodiscard]] double idle_w(double rev_per_min) const;
  // Part of the idle power at this speed that grows with n.
  [[nodiscard]] double coulomb_part(double rev_per_min) const;
};

// Or what the record lacks.
[[nodiscard]] Expected<TurningFit, std::string> fit_turning(const CutRecord& record);

}  // namespace stanok::process
