#include "runtime/drive_side/modbus_drives.h"

#include <algorithm>
#include <string>

#include "base/place.h"
#include "plant/modbus/machine_drives.h"

namespace stanok::runtime {
namespace {

std::vector<plant::SimulatedDriveConfig> drives_behind(DrivesBehindBus drives,
                                                       const config::MachineFile& file) {
  if (drives == DrivesBehindBus::simulated) return plant::drives_of(file);
  if (file.bus.kind != drives::BusKind::none) return {};
  throw config::ConfigError({{.file = file.path.string(),
                              .text = "real drives need a section [drives]; add it, or use "
                                      "embedded drives"}});
}

// The machine file gets its bus, and the bus its port.
std::unique_ptr<plant::ModbusServer> server_of(
    const std::vector<plant::SimulatedDriveConfig>& simulated, config::MachineFile& file) {
  if (simulated.empty()) return nullptr;
  auto server = std::make_unique<plant::ModbusServer>(
      plant::ServerConfig{.modules = plant::modules_of(file)}, simulated);
  server->start();
  file.bus = plant::simulated_bus(file);
  file.bus.port = server->port();
  return server;
}

}  // namespace

ModbusDrives::ModbusDrives(const DriveSurroundings& surroundings, DrivesBehindBus drives)
    : simulated_(drives_behind(drives, surroundings.file)),
      server_(server_of(simulated_, surroundings.file)),
      bus_(surroundings.file.bus, surroundings.file.machine.cycle_us * 1e-6 * second),
      exchange_(surroundings.file.machine, surroundings.file.bus, bus_),
      process_(surroundings.process),
      has_signals_(!surroundings.file.bus.signals.empty()) {}

void ModbusDrives::stop() {
  bus_.stop();
  if (server_) server_->stop();
}

std::optional<Signals> ModbusDrives::signals() RT_SAFE {
  if (!has_signals_) return std::nullopt;
  return bus_.read_signals();
}

// The simulated spindle drive bears what the cut asks for.
void ModbusDrives::write(const channels::CycleOutput& output) RT_SAFE {
  if (process_ != nullptr && server_) {
    const auto drive = exchange_.drive_of_spindle(process_->spindle());
    if (drive) server_->load(*drive, process_->load());
  }
  exchange_.write(output);
  if (has_signals_) bus_.write_signals(output.signals);
}

bool ModbusDrives::inject_fault(std::string_view drive, plant::FaultKind fault) {
  const auto found = std::ranges::find_if(simulated_, [&](const plant::SimulatedDriveConfig& one) {
    return one.registers.axis == drive;
  });
  if (found == simulated_.end()) return false;
  server_->inject(checked_size(found - simulated_.begin()), fault);
  return true;
}

}  // namespace stanok::runtime
