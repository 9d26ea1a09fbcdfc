// The drive bus as drives sees it. Filled by config from [drives] and [axis.drive] of the machine
// file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drives/register_map.h"
#include "drives/run_words.h"
#include "drives/signals.h"
#include "drives/vibration.h"

namespace stanok::drives {

// The functions of Modbus by which a drive is written: 23 together with a read, 16, or 6.
enum class RequestStyle : std::uint8_t { write_and_read, write_multiple, write_single };

// What a drive follows: a position, a velocity, or only the command to run.
enum class DriveKind : std::uint8_t { position, velocity, on_off };

// One drive on the bus (docs/integrator/drives.md).
struct AxisDriveConfig {
  std::string axis;
  int spindle = 0;  // number of the spindle that it turns; 0: it moves an axis
  int unit = 1;     // Modbus unit id
  DriveKind kind = DriveKind::position;
  RegisterMap map = register_map({});
  std::optional<RunWords> words{};  // absent: control and status word of CiA 402
  RequestStyle requests = RequestStyle::write_and_read;
  int gap_max = 0;                   // registers of no use that may be read along to save a request
  bool absolute_encoder = true;      // knows its position at power-on
  int watchdog_ms = 0;               // set in the drive: it stops by itself; 0: not known
  double following_error_max = 0.5;  // mm or deg
  // mm/s, deg/s, rev/min; feedback faster than twice this is absurd; 0: any
  double velocity_max = 0.0;
  // mm/s^2, deg/s^2; 0: not known.
  double acceleration_max = 0.0;         // of a stop out of sight
  double target_acceleration_max = 0.0;  // of what it is told, stops included
};

enum class BusKind { none, modbus_tcp, modbus_rtu };

struct BusConfig {
  BusKind kind = BusKind::none;
  std::string host = "127.0.0.1";
  int port = 502;
  std::string device{};  // RTU: serial device
  int baud = 115200;
  int poll_ms = 10;
  int timeout_ms = 250;
  std::vector<AxisDriveConfig> axes{};      // in machine axis order
  std::vector<AxisDriveConfig> spindles{};  // those that have a drive of their own
  std::vector<SignalConfig> signals{};
  std::vector<VibrationSensorConfig> vibration_sensors{};
};

// Axes, then spindles: the order of targets and feedback.
[[nodiscard]] std::vector<AxisDriveConfig> drives_of(const BusConfig& bus);

}  // namespace stanok::drives
