// What the power of a spindle drive tells of any cut: idle power over speed, the lag of the sensor,
// and the two figures on which the power of the cut depends.
//
//   N_d = a n + b n^2 + L[ P(c_1, c_2) ]
// L: a lag of first order and a delay, for what readings are late. Readings are weighted by their
// noise, which has a constant part and one that grows with the power of the cut and may remember
// that of the reading before. Each value has the interval in which it lies with 95 % probability,
// and the fit says whether the model fits. Off line.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "process/identify/drive_record.h"
#include "process/identify/fit_verdict.h"

namespace stanok::process {

struct Estimate {
  double value = 0.0;
  double low = 0.0;  // the interval
  double high = 0.0;

  [[nodiscard]] double half_width() const { return 0.5 * (high - low); }
  [[nodiscard]] bool contains(double number) const { return low <= number && number <= high; }
};

// The power of the cut by row, without the lag: `watts` has a place for each row.
struct CutModel {
  std::array<double, 2> begin{};
  std::array<double, 2> scale{};  // how far a figure has to move to matter
  std::function<void(const std::array<double, 2>& figures, std::vector<double>& watts)> power;
  // Of a unit of what the law of the force may lack; empty: nothing is known of that.
  std::vector<double> law_w;
};

struct DriveFit {
  Estimate idle_linear;                 // a, W per rev/min
  std::optional<Estimate> idle_square;  // b; none: the record has one speed only
  Estimate lag_s;                       // from 0 s: a reading may be a sampling period old
  double sampling_s = 0.0;              // of the sensor
  double noise = 0.0;                   // of the cutting power, standard deviation
  double residual_w = 0.0;              // rms
  int readings = 0;
  std::vector<double> fitted_w;  // by row
  FitVerdict verdict;

  [[nodiscard]] double idle_w(double rev_per_min) const;
  // Part of the idle power at this speed that grows with n.
  [[nodiscard]] double coulomb_part(double rev_per_min) const;
};

struct FittedCut {
  DriveFit drive;
  std::array<Estimate, 2> figures;
};

// Whether there are enough readings in the cut and out of it; empty: there are.
[[nodiscard]] std::string what_lacks(const DriveRecord& record);

inline constexpr const char* not_of_the_cut =
    "the power does not follow the cut; look whether spindle, tool and stock or workpiece are "
    "those "
    "that were cut";

// Or what the record lacks.
[[nodiscard]] Expected<FittedCut, std::string> fit_drive(const DriveRecord& record,
                                                         const CutModel& cut);

}  // namespace stanok::process
