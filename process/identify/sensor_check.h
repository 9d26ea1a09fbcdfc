// What a record of the power tells of its sensor, before any model: how often it shows a value, in
// which steps, and whether it is alive and within its range. Off line.
#pragma once

#include <cstddef>
#include <vector>

#include "process/identify/drive_record.h"
#include "process/identify/fit_verdict.h"

namespace stanok::process {

struct SensorTraits {
  double sampling_s = 0.0;  // from one new value to the next
  double step_w = 0.0;      // of the readings; small where they are not rounded
  double noise_w = 0.0;     // in the cut, from reading to reading, standard deviation
};

[[nodiscard]] SensorTraits sensor_traits(const DriveRecord& record);

// Without the repetitions of a sensor that shows each value for several readings.
[[nodiscard]] DriveRecord without_repetitions(const DriveRecord& record);

// `cut_w`: of a cut with usual figures, by row; only its changes are looked at.
[[nodiscard]] FitVerdict check_sensor(const DriveRecord& record, const SensorTraits& traits,
                                      const std::vector<double>& cut_w);

}  // namespace stanok::process
