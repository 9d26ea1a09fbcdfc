// The drive bus as drives sees it. Filled by config from [drives] and [axis.drive] of the machine
// file.
#pragma once

#include <string>
#include <vector>

namespace stanok::drives {

// Register map and scales of one drive (docs/drives.md). All positions as 32-bit integers over two
// registers, high word first.
struct AxisDriveConfig {
  std::string axis;
  int unit = 1;  // Modbus unit id
  int control_register =
      0;  // first register of the written block: control, target position, target velocity
  int status_register =
      100;  // first register of the read block: status, actual position, actual velocity, ...
  double position_scale = 1000.0;    // increments per mm or deg
  double velocity_scale = 1000.0;    // increments/s per mm/s or deg/s
  double following_error_max = 0.5;  // mm or deg
  double velocity_max = 0.0;  // mm/s or deg/s; feedback faster than twice this is absurd; 0: any
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
  std::vector<AxisDriveConfig> axes{};  // in machine axis order
};

}  // namespace stanok::drives
