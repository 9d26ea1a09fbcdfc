// Simulated drives made from what the machine says of its real ones.
#include "plant/mechanics/plant_config.h"

#include <algorithm>

namespace stanok::plant {

double watchdog_of(const drives::BusConfig& bus) {
  return std::max(WatchConfig{}.watchdog_s, 2e-3 * bus.timeout_ms);
}

std::vector<SimulatedDriveConfig> drives_of(const drives::BusConfig& bus,
                                            std::span<const double> start) {
  std::vector<SimulatedDriveConfig> drives;
  for (const drives::AxisDriveConfig& registers : bus.axes) {
    SimulatedDriveConfig drive{.registers = registers};
    if (drives.size() < start.size()) {
      drive.start = start[drives.size()];
    }
    drive.axis.velocity_max = 1.2 * registers.velocity_max;  // a drive has some reserve
    drive.watch.following_error_max = registers.following_error_max;
    drive.watch.watchdog_s = watchdog_of(bus);
    drives.push_back(drive);
  }
  return drives;
}

SimulatedDriveConfig spindle_drive(int id, const SpindlePlantConfig& config) {
  SimulatedDriveConfig drive{.kind = PlantKind::spindle, .spindle = config};
  drive.registers.axis = "S" + std::to_string(id);
  drive.registers.spindle = id;
  drive.registers.unit = spindle_unit_base + id;
  drive.registers.kind = drives::DriveKind::velocity;
  drive.registers.map = drives::register_map({.position_scale = 100.0, .velocity_scale = 1.0});
  return drive;
}

}  // namespace stanok::plant
