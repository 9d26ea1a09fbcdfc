// The simulated drives of a machine file: one per axis and spindle.
#pragma once

#include <vector>

#include "config/files/machine_file.h"
#include "drives/bus_config.h"
#include "plant/mechanics/plant_config.h"
#include "plant/modbus/drive_bank.h"

namespace stanok::plant {

// The bus of the machine with every axis on it, as Modbus TCP on loopback; the port is the
// server's. A machine without [drives] gets the default registers and units 1, 2, ...
[[nodiscard]] drives::BusConfig simulated_bus(const config::MachineFile& machine);

// In machine axis order, at their start positions; then the spindles.
[[nodiscard]] std::vector<SimulatedDriveConfig> drives_of(const config::MachineFile& machine);

// Those of them that the bus exchanges with, in the order of the bus.
[[nodiscard]] std::vector<SimulatedDriveConfig> drives_on_bus(const config::MachineFile& machine);

// Units that have signals of programs and no drive, and vibration sensors.
[[nodiscard]] ModuleConfig modules_of(const config::MachineFile& machine);

}  // namespace stanok::plant
