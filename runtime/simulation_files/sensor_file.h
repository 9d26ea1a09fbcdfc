// Sensor values over machine time, for a simulation: CSV with a head line.
//
// Columns: `t` in s, ascending; `power_w`, `vibration_um`, `vibration_hz` of the first spindle, or
// of the spindle with id N where `.N` stands behind the name. Values hold until the next row;
// before the first row, and where a cell is empty, the sensor gives none.
#pragma once

#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "runtime/simulation.h"

namespace stanok::runtime {

// Throws std::runtime_error "file:line:column: reason" on anything that is no such file.
[[nodiscard]] std::vector<SensorRow> read_sensor_file(
    const std::string& path, const std::vector<channels::SpindleConfig>& spindles);

}  // namespace stanok::runtime
