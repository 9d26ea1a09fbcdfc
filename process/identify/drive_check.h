// Whether the model of a cut fits the power of a drive, and what has been missing where it does
// not. Off line.
#pragma once

#include <cstddef>
#include <vector>

#include "process/identify/coloured_noise.h"
#include "process/identify/drive_record.h"
#include "process/identify/fit_verdict.h"
#include "process/identify/model_check.h"

namespace stanok::process {

// Powers by row, behind the lag of the sensor.
struct DrivePowers {
  std::vector<double> cut_w;
  std::vector<double> lag_w{};  // change of the power by a second lag; empty: it is not looked at
  std::vector<double> law_w{};  // of what the law of the force may lack; empty: nothing is known
};

struct DriveVerdict {
  FitVerdict verdict;
  Parameters moved{};  // by how much the parameters may be wrong; empty: by nothing
};

[[nodiscard]] DriveVerdict check_drive(const DriveRecord& record, const DrivePowers& powers,
                                       const ColouredNoise& noise, const FitTraces& traces);

}  // namespace stanok::process
