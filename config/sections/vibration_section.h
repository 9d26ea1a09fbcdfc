// [[vibration_sensor]]: a sensor that delivers blocks of samples, on the bus of the drives.
#pragma once

#include <vector>

#include "config/text/key_table.h"
#include "drives/vibration.h"

namespace stanok::config {

// `poll_ms` is that of the bus: a block must hold what is sampled in a poll.
[[nodiscard]] std::vector<drives::VibrationSensorConfig> read_vibration_sensors(Subtables sensors,
                                                                                int poll_ms,
                                                                                const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> vibration_sensor_key_rows();

}  // namespace stanok::config
