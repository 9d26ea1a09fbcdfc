// Requests carried out on simulated drives: register writes become commands, status becomes
// registers.
#include "plant/modbus/drive_bank.h"

#include <algorithm>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::plant {
namespace {

constexpr std::chrono::milliseconds caught_up_max{500};

modbus_mapping_t* holding_registers(int count) {
  modbus_mapping_t* mapping = modbus_mapping_new(0, 0, count, 0);
  STANOK_ASSERT(mapping != nullptr);
  return mapping;
}

std::span<std::uint16_t> image_of(modbus_mapping_t& mapping) {
  return {mapping.tab_registers, checked_size(mapping.nb_registers)};
}

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

DriveBank::Slot::Slot(const SimulatedDriveConfig& config)
    : drive(config), registers(holding_registers(drives::register_count(config.registers.map))) {}

DriveBank::DriveBank(const std::vector<SimulatedDriveConfig>& drives, const ModuleConfig& modules,
                     double step_s)
    : modules_(modules.signals.begin(), modules.signals.end()),
      panel_(holding_registers(static_cast<int>(drives.size()))),
      step_s_(step_s) {
  for (const SimulatedDriveConfig& drive : drives) {
    drives_.emplace_back(drive);
  }
  for (const drives::VibrationSensorConfig& sensor : modules.vibration)
    vibrations_.emplace_back(sensor);
}

// Each sensor sits on its spindle.
void DriveBank::sample_vibration(double dt_s) {
  for (VibrationModule& module : vibrations_) {
    const auto spindle = std::ranges::find_if(drives_, [&](const Slot& slot) {
      return slot.drive.config().registers.spindle == module.config().spindle;
    });
    const bool is_there = spindle != drives_.end();
    module.advance(is_there ? spindle->drive.process_load() : ProcessLoad{}, dt_s);
  }
}

void DriveBank::advance_to(std::chrono::nanoseconds time) {
  apply_injections();
  time_ = std::max(time_, time - caught_up_max);
  while (time_ < time) {
    const auto step =
        std::min(time - time_, std::chrono::nanoseconds{static_cast<std::int64_t>(step_s_ * 1e9)});
    for (Slot& slot : drives_) {
      slot.drive.advance(seconds(step));
    }
    sample_vibration(seconds(step));
    time_ += step;
  }
}

void DriveBank::apply_injections() {
  for (Slot& slot : drives_) {
    slot.drive.load(slot.load.read());
    const std::uint16_t injected = slot.injected.load();
    if (injected != slot.injected_seen) {
      slot.drive.inject(static_cast<FaultKind>(injected));
      slot.injected_seen = static_cast<std::uint16_t>(slot.drive.fault());
      std::uint16_t expected = injected;
      slot.injected.compare_exchange_strong(expected, slot.injected_seen);
    }
  }
}

DriveBank::Slot* DriveBank::slot_of(int unit) {
  const auto found = std::find_if(drives_.begin(), drives_.end(), [&](const Slot& slot) {
    return slot.drive.config().registers.unit == unit;
  });
  return found == drives_.end() ? nullptr : &*found;
}

SignalModule* DriveBank::module_of(int unit) {
  const auto found = std::ranges::find(modules_, unit, &SignalModule::unit);
  return found == modules_.end() ? nullptr : &*found;
}

VibrationModule* DriveBank::vibration_of(int unit) {
  const auto found = std::ranges::find_if(
      vibrations_, [&](const VibrationModule& module) { return module.config().unit == unit; });
  return found == vibrations_.end() ? nullptr : &*found;
}

std::optional<AnswerKind> DriveBank::answer_kind(int unit) {
  if (Slot* slot = slot_of(unit)) {
    return slot->drive.answer_kind();
  }
  const bool is_there =
      unit == fault_panel_unit || module_of(unit) != nullptr || vibration_of(unit) != nullptr;
  return is_there ? std::optional(AnswerKind::normal) : std::nullopt;
}

modbus_mapping_t* DriveBank::registers_after(int unit, std::span<const std::uint8_t> pdu) {
  const auto write = register_write(pdu);
  if (Slot* slot = slot_of(unit)) {
    if (write) {
      write_drive(*slot, *write);
    }
    show_status(*slot);
    return slot->registers.get();
  }
  if (SignalModule* module = module_of(unit)) {
    return module->registers();  // libmodbus writes into them as it answers
  }
  if (VibrationModule* module = vibration_of(unit)) {
    return module->registers();
  }
  STANOK_ASSERT(unit == fault_panel_unit);
  if (write) {
    write_panel(*write);
  }
  show_faults();
  return panel_.get();
}

// A request beyond the registers is left to libmodbus, which refuses it with an exception.
void DriveBank::write_drive(Slot& slot, const RegisterWrite& write) {
  modbus_mapping_t& mapping = *slot.registers;
  const RegisterRange written{write.first, static_cast<int>(write.values.size())};
  if (!written.is_within(mapping.nb_registers) || !write.read.is_within(mapping.nb_registers)) {
    return;
  }
  std::copy(write.values.begin(), write.values.end(), mapping.tab_registers + write.first);
  const drives::RegisterMap& map = slot.drive.config().registers.map;
  const bool touches_command =
      std::ranges::any_of(drives::written_fields, [&](drives::FieldOfMap member) {
        const drives::RegisterField& field = map.*member;
        return field.exists() && written.first < field.end() &&
               written.first + written.count > field.address;
      });
  if (touches_command) {
    slot.drive.command(drives::command_block(map, image_of(mapping)));
  }
}

void DriveBank::write_panel(const RegisterWrite& write) {
  const RegisterRange written{write.first, static_cast<int>(write.values.size())};
  const bool are_faults = std::all_of(write.values.begin(), write.values.end(),
                                      [](std::uint16_t value) { return value < fault_kind_count; });
  if (!are_faults || !written.is_within(static_cast<int>(drives_.size()))) {
    return;
  }
  for (std::size_t i = 0; i < write.values.size(); ++i) {
    drives_[checked_size(write.first) + i].injected.store(write.values[i]);
  }
  apply_injections();
}

void DriveBank::show_faults() {
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    panel_->tab_registers[i] = drives_[i].injected.load();
  }
}

void DriveBank::show_status(Slot& slot) {
  drives::write_block(slot.drive.config().registers.map, slot.drive.status(),
                      image_of(*slot.registers));
}

void DriveBank::inject(std::size_t drive, FaultKind kind) {
  STANOK_ASSERT(drive < drives_.size());
  drives_[drive].injected.store(static_cast<std::uint16_t>(kind));
}

void DriveBank::load(std::size_t drive, const ProcessLoad& load) RT_SAFE {
  drives_[drive].load.write(load);
}

}  // namespace stanok::plant
