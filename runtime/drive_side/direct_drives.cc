#include "runtime/drive_side/direct_drives.h"

#include <algorithm>

#include "base/place.h"
#include "plant/modbus/machine_drives.h"

namespace stanok::runtime {
namespace {

// The machine file gets their bus. Of a machine that is on from the first cycle the axes know where
// they are; what is a spindle still has its reference to find.
std::vector<plant::SimulatedDriveConfig> drives_on_own_bus(const DriveSurroundings& surroundings) {
  config::MachineFile& file = surroundings.file;
  file.bus = plant::simulated_bus(file);
  std::vector<plant::SimulatedDriveConfig> drives = plant::drives_on_bus(file);
  if (!surroundings.options.on_at_start) return drives;
  for (std::size_t k = 0; k < file.machine.axes.size(); ++k) {
    const bool turns = std::ranges::any_of(file.machine.spindles, [&](const auto& one) {
      return one.axis == file.machine.axes[k].name;
    });
    if (!turns) drives[k].reference.absolute_encoder = true;
  }
  return drives;
}

}  // namespace

DirectDrives::DirectDrives(const DriveSurroundings& surroundings)
    : simulated_(drives_on_own_bus(surroundings)),
      bus_(surroundings.file.bus, simulated_, surroundings.file.machine.cycle_us * 1e-6 * second),
      exchange_(surroundings.file.machine, surroundings.file.bus, bus_),
      process_(surroundings.process) {}

// The spindle drive bears what the cut asks for.
void DirectDrives::write(const channels::CycleOutput& output) RT_SAFE {
  if (process_ != nullptr) {
    const auto drive = exchange_.drive_of_spindle(process_->spindle());
    if (drive) bus_.load(*drive, process_->load());
  }
  exchange_.write(output);
}

bool DirectDrives::inject_fault(std::string_view drive, plant::FaultKind fault) {
  const auto found = std::ranges::find_if(simulated_, [&](const plant::SimulatedDriveConfig& one) {
    return one.registers.axis == drive;
  });
  if (found == simulated_.end()) return false;
  bus_.inject(checked_size(found - simulated_.begin()), fault);
  return true;
}

}  // namespace stanok::runtime
