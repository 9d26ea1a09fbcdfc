// The keys of [[vibration_sensor]] and their checks.
#include "config/sections/vibration_section.h"

#include <cmath>

namespace stanok::config {
namespace {

using drives::VibrationSensorConfig;

const Keys<VibrationSensorConfig>& vibration_sensor_keys() {
  static const Keys<VibrationSensorConfig> keys = {
      {"spindle", at<&VibrationSensorConfig::spindle>, required, "",
       "number of the spindle on which it is mounted", from(1, 16)},
      {"address", at<&VibrationSensorConfig::unit>, required, "", "Modbus unit of the sensor",
       from(1, 247)},
      {"register", at<&VibrationSensorConfig::first_register>, required, "",
       "register with the number of samples taken so far; the samples follow, oldest first",
       from(0, 65000)},
      {"count", at<&VibrationSensorConfig::count>, optional, "", "number of samples in the block",
       from(1, VibrationSensorConfig::count_max)},
      {"rate", at<&VibrationSensorConfig::rate_hz>, optional, "Hz", "samples per second", positive},
      {"scale", at<&VibrationSensorConfig::scale>, optional, "1/um", "increments per unit",
       positive},
  };
  return keys;
}

}  // namespace

std::vector<VibrationSensorConfig> read_vibration_sensors(Subtables sensors, int poll_ms,
                                                          const Scope& scope) {
  std::vector<VibrationSensorConfig> configs;
  if (sensors == nullptr) return configs;
  for (const toml::node& node : *sensors) {
    const toml::table& table = *node.as_table();
    const Scope inner{scope.faults, "vibration sensor " + std::to_string(configs.size() + 1)};
    VibrationSensorConfig config;
    read_table(table, vibration_sensor_keys(), config, inner);
    const double per_poll = config.rate_hz * poll_ms * 1e-3;
    if (per_poll > config.count) {
      inner.fault(place_of(table, "count"),
                  "count is " + std::to_string(config.count) +
                      "; with poll_ms = " + std::to_string(poll_ms) + " the sensor takes " +
                      number_text(std::ceil(per_poll)) +
                      " samples in a poll, and some would be lost; poll more often");
    }
    configs.push_back(config);
  }
  return configs;
}

std::vector<KeyRow> vibration_sensor_key_rows() {
  return describe(vibration_sensor_keys());
}

}  // namespace stanok::config
