// From the sections of a machine file to simulated drives.
#include "plant/modbus/machine_drives.h"

#include <algorithm>

#include "base/units.h"

namespace stanok::plant {
namespace {

drives::AxisDriveConfig default_drive(const channels::AxisConfig& axis, int place) {
  const bool in_cycle = axis.controller.feedback == channels::FeedbackPlace::cycle;
  return {.axis = axis.name,
          .unit = place,
          .kind = in_cycle ? drives::DriveKind::velocity : drives::DriveKind::position,
          .absolute_encoder = axis.homing.order == 0,
          .following_error_max = axis.following_error_max,
          .velocity_max = axis.limits.velocity_max,
          .acceleration_max = axis.limits.acceleration_max,
          .target_acceleration_max = axis.limits.stop_limits * axis.limits.acceleration_max};
}

VelocityLoopConfig velocity_loop(const config::SimulationConfig& simulation) {
  return {.bandwidth_hz = simulation.servo_frequency_hz,
          .damping = simulation.servo_damping,
          .resonance_hz = simulation.resonance_frequency_hz,
          .resonance_damping = simulation.resonance_damping};
}

ReferenceConfig reference(const config::AxisSimulation& plant) {
  return {.absolute_encoder = plant.absolute_encoder,
          .home_switch_from = plant.home_switch_from,
          .home_switch_to = plant.home_switch_to,
          .limit_negative = plant.limit_negative,
          .limit_positive = plant.limit_positive,
          .index_position = plant.index_position,
          .index_pitch = plant.index_pitch,
          .backlash = plant.backlash};
}

// The motor of an axis that is a spindle until M902 reaches the speed of the spindle.
void let_turn(const channels::SpindleConfig& spindle, std::vector<SimulatedDriveConfig>& drives) {
  constexpr double reserve = 1.2;
  for (SimulatedDriveConfig& drive : drives) {
    if (spindle.axis.empty() || drive.registers.axis != spindle.axis) continue;
    drive.axis.velocity_max =
        std::max(drive.axis.velocity_max, reserve * deg_per_s_of_rev_per_min * spindle.speed_max);
  }
}

}  // namespace

drives::BusConfig simulated_bus(const config::MachineFile& machine) {
  drives::BusConfig bus = machine.bus;
  bus.kind = drives::BusKind::modbus_tcp;
  bus.host = "127.0.0.1";
  if (bus.axes.empty()) {
    for (const channels::AxisConfig& axis : machine.machine.axes) {
      bus.axes.push_back(default_drive(axis, static_cast<int>(bus.axes.size()) + 1));
    }
  }
  return bus;
}

std::vector<SimulatedDriveConfig> drives_of(const config::MachineFile& machine) {
  std::vector<double> start;
  start.reserve(machine.machine.axes.size());
  for (const channels::AxisConfig& axis : machine.machine.axes) {
    start.push_back(axis.start);
  }
  std::vector<SimulatedDriveConfig> drives = drives_of(simulated_bus(machine), start);
  for (std::size_t k = 0; k < drives.size(); ++k) {
    SimulatedDriveConfig& drive = drives[k];
    drive.axis.bandwidth_hz = machine.simulation.drive_frequency_hz;
    drive.axis.damping = machine.simulation.drive_damping;
    drive.velocity_loop = velocity_loop(machine.simulation);
    if (k < machine.axis_plants.size()) {
      drive.axis.dry_friction = machine.axis_plants[k].dry_friction;
      drive.reference = reference(machine.axis_plants[k]);
    }
    if (machine.machine.axes[k].controller.feedback == channels::FeedbackPlace::cycle)
      drive.kind = PlantKind::velocity_axis;
  }
  for (const channels::SpindleConfig& spindle : machine.machine.spindles) {
    let_turn(spindle, drives);
    SpindlePlantConfig plant{.acceleration = spindle.acceleration};
    if (spindle.speed_max > 0.0) {
      plant.speed_max = spindle.speed_max;
    }
    if (spindle.power_idle_w > 0.0) {
      plant.power_idle_w = spindle.power_idle_w;
    }
    drives.push_back(spindle_drive(spindle.id, plant));
    drives.back().watch.watchdog_s = watchdog_of(machine.bus);
    const auto on_bus =
        std::ranges::find(machine.bus.spindles, spindle.id, &drives::AxisDriveConfig::spindle);
    if (on_bus != machine.bus.spindles.end()) drives.back().registers = *on_bus;
  }
  return drives;
}

std::vector<SimulatedDriveConfig> drives_on_bus(const config::MachineFile& machine) {
  std::vector<SimulatedDriveConfig> drives = drives_of(machine);
  std::erase_if(drives, [&](const SimulatedDriveConfig& drive) {
    return drive.registers.spindle != 0 &&
           std::ranges::find(machine.bus.spindles, drive.registers.spindle,
                             &drives::AxisDriveConfig::spindle) == machine.bus.spindles.end();
  });
  return drives;
}

ModuleConfig modules_of(const config::MachineFile& machine) {
  ModuleConfig modules{.signals = {}, .vibration = machine.bus.vibration_sensors};
  std::vector<int>& units = modules.signals;
  const std::vector<SimulatedDriveConfig> drives = drives_of(machine);
  for (const drives::SignalConfig& signal : machine.bus.signals) {
    const bool is_drive = std::ranges::any_of(drives, [&](const SimulatedDriveConfig& drive) {
      return drive.registers.unit == signal.unit;
    });
    if (!is_drive && std::ranges::find(units, signal.unit) == units.end())
      units.push_back(signal.unit);
  }
  return modules;
}

}  // namespace stanok::plant
