#include "runtime/drive_side/drive_exchange.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/place.h"

namespace stanok::runtime {
namespace {

constexpr double spindle_rest_rev_per_min = 1.0;
constexpr int fault_reset_polls = 5;  // of the bus, so that the demand reaches the drive for sure

channels::AxisFeedback feedback_of(const drives::DriveFeedback& raw) RT_SAFE {
  const bool fault = raw.state == drives::DriveState::fault ||
                     raw.state == drives::DriveState::fault_reaction_active;
  return {.position = raw.position,
          .setpoint = raw.target_position,
          .velocity = raw.velocity,
          .valid = raw.valid,
          .fault = fault,
          .enabled = raw.state == drives::DriveState::operation_enabled,
          .referenced = raw.referenced,
          .brake_closed = raw.brake_closed,
          .home_switch = raw.home_switch,
          .limit_negative = raw.limit_negative,
          .limit_positive = raw.limit_positive,
          .strays = raw.following_error_exceeded,
          .position_offset = raw.position_offset,
          .index_position = raw.index_position,
          .index_count = raw.index_count};
}

void aim(drives::DriveTarget& target, const channels::ChannelOutput& channel, std::size_t axis)
    RT_SAFE {
  target.position = channel.axes[axis].position;
  target.velocity = channel.axes[axis].velocity_demand;
  target.mode = channel.drives[axis].follows_velocity
                    ? drives::OperationMode::cyclic_synchronous_velocity
                    : drives::OperationMode::cyclic_synchronous_position;
  target.enabled = channel.drives[axis].enabled;
  target.brake_closed = channel.drives[axis].brake_closed;
  target.position_accepted = channel.drives[axis].reference.accepted;
  target.position_offset = channel.drives[axis].reference.offset;
}

double spindle_speed(const channels::CycleOutput& output, int id) RT_SAFE {
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    for (const channels::SpindleSetpoint& spindle : channel.process.spindles) {
      if (spindle.id == id && spindle.rev_per_min != 0.0) return spindle.rev_per_min;
    }
  }
  return 0.0;
}

}  // namespace

DriveExchange::DriveExchange(const channels::MachineConfig& machine,
                             const drives::BusConfig& config, drives::DriveBus& bus)
    : machine_(machine),
      bus_(bus),
      drives_(drives::drives_of(config)),
      sensors_(machine.spindles.size()),
      reset_cycles_(fault_reset_polls * config.poll_ms * 1000 / machine.cycle_us) {
  if (drives_.size() > drives_of_machine_max) {
    throw std::invalid_argument(machine.file + ": more than " +
                                std::to_string(drives_of_machine_max) + " drives");
  }
  find_spindle_drives();
  find_vibration_sensors(config);
}

void DriveExchange::find_spindle_drives() {
  for (const channels::SpindleConfig& spindle : machine_.spindles) {
    std::optional<std::size_t> drive;
    for (std::size_t k = 0; k < machine_.axes.size() && !drive; ++k) {
      if (machine_.axes[k].name == spindle.axis) drive = k;
    }
    for (std::size_t k = drives_.size(); k-- > 0;) {
      if (drives_[k].spindle == spindle.id) drive = k;
    }
    spindle_drives_.push_back(drive);
  }
}

void DriveExchange::find_vibration_sensors(const drives::BusConfig& config) {
  for (const channels::SpindleConfig& spindle : machine_.spindles) {
    const auto sensor = std::ranges::find(config.vibration_sensors, spindle.id,
                                          &drives::VibrationSensorConfig::spindle);
    vibration_sensors_.push_back(
        sensor == config.vibration_sensors.end()
            ? std::nullopt
            : std::optional(checked_size(sensor - config.vibration_sensors.begin())));
  }
}

void DriveExchange::read(std::span<const channels::OperatorEvent> events) RT_SAFE {
  take_feedback();
  note_fault_resets(events);
}

void DriveExchange::take_feedback() RT_SAFE {
  bus_.read({raw_feedback_.data(), drives_.size()});
  for (std::size_t k = 0; k < machine_.axes.size(); ++k)
    feedback_[k] = feedback_of(raw_feedback_[k]);
}

std::span<const channels::SpindleSensors> DriveExchange::sensors() RT_SAFE {
  for (std::size_t s = 0; s < sensors_.size(); ++s) {
    sensors_[s] = {};
    if (spindle_drives_[s]) {
      const drives::DriveFeedback& raw = raw_feedback_[*spindle_drives_[s]];
      if (raw.valid) {
        sensors_[s] = {.power_w = raw.power_w,
                       .vibration_um = raw.vibration_um,
                       .vibration_hz = raw.vibration_hz};
      }
    }
    if (!vibration_sensors_[s]) continue;
    const auto level = bus_.read_vibration_level(*vibration_sensors_[s]);
    if (!level) continue;
    sensors_[s].vibration_um = level->amplitude_um;
    sensors_[s].vibration_hz = level->frequency_hz;
  }
  return sensors_;
}

void DriveExchange::write(const channels::CycleOutput& output) RT_SAFE {
  for (int c = 0; c < output.channel_count; ++c) {
    const AxisList<int>& axes = machine_.channels[c].axes;
    for (std::size_t k = 0; k < axes.size(); ++k) aim(targets_[axes[k]], output.channels[c], k);
  }
  turn_spindles(output);
  carry_out_fault_resets();
  bus_.write({targets_.data(), drives_.size()});
}

void DriveExchange::pass(int late) RT_SAFE {
  const double late_s = 1e-6 * machine_.cycle_us * late;
  for (std::size_t k = 0; k < drives_.size(); ++k)
    carried_[k] = drives::carried_on(targets_[k], late_s);
  bus_.write({carried_.data(), drives_.size()});
}

// The channel that turns a spindle has it; one that has come to rest is switched off.
void DriveExchange::turn_spindles(const channels::CycleOutput& output) RT_SAFE {
  for (std::size_t k = machine_.axes.size(); k < drives_.size(); ++k) {
    drives::DriveTarget& target = targets_[k];
    target.velocity = spindle_speed(output, drives_[k].spindle);
    target.mode = drives::OperationMode::cyclic_synchronous_velocity;
    const bool turns = std::abs(raw_feedback_[k].velocity) > spindle_rest_rev_per_min;
    target.enabled = target.velocity != 0.0 || (target.enabled && turns);
    target.brake_closed = false;
  }
}

// Who resets a channel or switches the machine on wants its drives back: the faults they stand in
// are acknowledged, with the drive switched off meanwhile.
void DriveExchange::note_fault_resets(std::span<const channels::OperatorEvent> events) RT_SAFE {
  using channels::OperatorAction;
  for (const channels::OperatorEvent& event : events) {
    const bool is_reset = event.action() == OperatorAction::program_reset;
    if (!is_reset && event.action() != OperatorAction::machine_on) continue;
    for (const channels::ChannelConfig& channel : machine_.channels) {
      if (is_reset && channel.id != event.channel) continue;
      for (std::size_t k = 0; k < drives_.size(); ++k) {
        if (has_drive(channel, k)) acknowledge(k);
      }
    }
  }
}

// Whether the drive, in the order of the bus, moves an axis or turns a spindle of the channel.
bool DriveExchange::has_drive(const channels::ChannelConfig& channel, std::size_t drive) const
    RT_SAFE {
  if (drive >= machine_.axes.size())
    return std::ranges::find(channel.spindles, drives_[drive].spindle) != channel.spindles.end();
  return std::ranges::any_of(channel.axes,
                             [drive](int axis) RT_SAFE { return std::cmp_equal(axis, drive); });
}

void DriveExchange::acknowledge(std::size_t drive) RT_SAFE {
  if (raw_feedback_[drive].state == drives::DriveState::fault)
    fault_reset_cycles_[drive] = reset_cycles_;
}

void DriveExchange::carry_out_fault_resets() RT_SAFE {
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    if (reset_demands_[k].exchange(false, std::memory_order_relaxed)) acknowledge(k);
    targets_[k].fault_reset = fault_reset_cycles_[k] > 0;
    if (fault_reset_cycles_[k] == 0) continue;
    --fault_reset_cycles_[k];
    targets_[k].enabled = false;
  }
}

bool DriveExchange::demand_reset(std::string_view drive) {
  const auto found = std::ranges::find(drives_, drive, &drives::AxisDriveConfig::axis);
  if (found == drives_.end()) return false;
  reset_demands_[checked_size(found - drives_.begin())] = true;
  return true;
}

}  // namespace stanok::runtime
