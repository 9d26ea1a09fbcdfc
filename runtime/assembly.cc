#include "runtime/assembly.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "drives/modbus/modbus_bus.h"
#include "plant/drive/direct_bus.h"
#include "plant/modbus/machine_drives.h"
#include "plant/modbus/modbus_server.h"
#include "runtime/force_controls.h"
#include "runtime/output_book.h"
#include "runtime/program_files.h"

namespace stanok::runtime {
namespace {

constexpr std::size_t axes_of_machine_max = 64;
constexpr std::size_t drives_of_machine_max = axes_of_machine_max + 16;  // and the spindles
constexpr double spindle_rest_rev_per_min = 1.0;
constexpr int fault_reset_polls = 5;  // of the bus, so that the demand reaches the drive for sure

}  // namespace

struct Assembly::Parts {
  explicit Parts(AssemblyOptions given)
      : options(std::move(given)),
        files(options.program_roots, options.file.machine.program_bounds.bytes, &texts),
        force_controls(options.file),
        machine(options.file.machine, files, force_controls.given_to(options.machine)),
        axis_count(options.file.machine.axes.size()) {
    if (axis_count > axes_of_machine_max) {
      throw std::invalid_argument(options.file.machine.file + ": more than " +
                                  std::to_string(axes_of_machine_max) + " axes");
    }
    if (options.output_capacity > 0) {
      outputs = std::make_unique<OutputBook>(options.output_capacity, machine.events());
    }
    make_bus();
    find_spindle_drives();
    if (options.drives != DriveChoice::real && !options.file.simulation.cutting.stock.empty())
      process_plant = std::make_unique<ProcessPlant>(options.file);
    reset_cycles =
        fault_reset_polls * options.file.bus.poll_ms * 1000 / options.file.machine.cycle_us;
  }

  // The spindle drive bears what the cut asks for.
  void load_spindle() RT_SAFE {
    const int drive = spindle_drives[process_plant->spindle()];
    if (drive < 0) return;
    const auto index = static_cast<std::size_t>(drive);
    if (direct != nullptr) direct->load(index, process_plant->load());
    if (server) server->load(index, process_plant->load());
  }

  void make_bus() {
    const Duration cycle = options.file.machine.cycle_us * 1e-6 * second;
    drives::BusConfig& bus_config = options.file.bus;
    switch (options.drives) {
      case DriveChoice::ideal:
        return;
      case DriveChoice::simulated:
        bus_config = plant::simulated_bus(options.file);
        simulated = drives_at_start();
        {
          auto made = std::make_unique<plant::DirectBus>(bus_config, simulated, cycle);
          direct = made.get();
          bus = std::move(made);
        }
        break;
      case DriveChoice::embedded:
        simulated = plant::drives_of(options.file);
        server = std::make_unique<plant::ModbusServer>(
            plant::ServerConfig{.modules = plant::modules_of(options.file)}, simulated);
        server->start();
        bus_config = plant::simulated_bus(options.file);
        bus_config.port = server->port();
        break;
      case DriveChoice::real:
        if (bus_config.kind != drives::BusKind::none) break;
        throw config::ConfigError({{.file = options.file.path.string(),
                                    .text = "real drives need a section [drives]; add it, or use "
                                            "embedded drives"}});
    }
    if (!bus) bus = std::make_unique<drives::ModbusBus>(bus_config, cycle);
    bus_drives = drives::drives_of(bus_config);
    drive_count = bus_drives.size();
    has_signals = options.drives != DriveChoice::simulated && !bus_config.signals.empty();
    if (drive_count > drives_of_machine_max) {
      throw std::invalid_argument(options.file.machine.file + ": more than " +
                                  std::to_string(drives_of_machine_max) + " drives");
    }
  }

  // Of a machine that is on from the first cycle the axes know where they are; what is a spindle
  // still has its reference to find.
  [[nodiscard]] std::vector<plant::SimulatedDriveConfig> drives_at_start() const {
    std::vector<plant::SimulatedDriveConfig> drives = plant::drives_on_bus(options.file);
    if (!options.machine.on_at_start) return drives;
    for (std::size_t k = 0; k < axis_count; ++k) {
      const bool turns = std::ranges::any_of(options.file.machine.spindles, [&](const auto& one) {
        return one.axis == options.file.machine.axes[k].name;
      });
      if (!turns) drives[k].reference.absolute_encoder = true;
    }
    return drives;
  }

  // What the programs' inputs are in this cycle; nothing where neither the bus nor a simulated
  // contact has any.
  [[nodiscard]] const Signals* read_signals() RT_SAFE {
    const bool has_contacts = options.drives != DriveChoice::real && !options.file.contacts.empty();
    if (!has_signals && !has_contacts) return nullptr;
    inputs = options.machine.outputs_to_inputs ? output.signals : Signals{};
    if (has_signals) inputs = bus->read_signals();
    if (has_contacts) switch_contacts();
    return &inputs;
  }

  void switch_contacts() RT_SAFE {
    for (const config::SimulatedContact& contact : options.file.contacts) {
      const double position = position_of(contact.axis);
      if (position >= contact.from && position <= contact.to) inputs.set(contact.input, true);
    }
  }

  // Of an axis of the machine: as its drive tells, or as it was set last.
  [[nodiscard]] double position_of(int axis) const RT_SAFE {
    const auto k = static_cast<std::size_t>(axis);
    if (bus) return raw_feedback[k].position;
    for (std::size_t c = 0; c < options.file.machine.channels.size(); ++c) {
      const std::vector<int>& axes = options.file.machine.channels[c].axes;
      const auto place = std::ranges::find(axes, axis);
      if (place != axes.end() && output.channel_count > 0)
        return output.channels[c].axes[static_cast<std::size_t>(place - axes.begin())].position;
    }
    return options.file.machine.axes[k].start;
  }

  void write_signals() RT_SAFE {
    if (has_signals) bus->write_signals(output.signals);
  }

  void find_spindle_drives() {
    const channels::MachineConfig& config = options.file.machine;
    sensors.resize(config.spindles.size());
    for (const channels::SpindleConfig& spindle : config.spindles) {
      const auto axis = std::ranges::find(config.axes, spindle.axis, &channels::AxisConfig::name);
      const auto own = std::ranges::find(bus_drives, spindle.id, &drives::AxisDriveConfig::spindle);
      int drive = -1;
      if (axis != config.axes.end()) drive = static_cast<int>(axis - config.axes.begin());
      if (own != bus_drives.end()) drive = static_cast<int>(own - bus_drives.begin());
      spindle_drives.push_back(drive);
    }
  }

  // Feedback of the drives as the machine takes it.
  void read_drives() RT_SAFE {
    bus->read({raw_feedback.data(), drive_count});
    for (std::size_t k = 0; k < axis_count; ++k) {
      const drives::DriveFeedback& raw = raw_feedback[k];
      const bool fault = raw.state == drives::DriveState::fault ||
                         raw.state == drives::DriveState::fault_reaction_active;
      feedback[k] = {.position = raw.position,
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
  }

  // Of the spindles that have a drive on the bus, their own or that of their axis.
  std::span<const channels::SpindleSensors> read_sensors() RT_SAFE {
    for (std::size_t s = 0; s < sensors.size(); ++s) {
      sensors[s] = {};
      if (spindle_drives[s] < 0) continue;
      const drives::DriveFeedback& raw = raw_feedback[static_cast<std::size_t>(spindle_drives[s])];
      if (!raw.valid) continue;
      sensors[s] = {.power_w = raw.power_w,
                    .vibration_um = raw.vibration_um,
                    .vibration_hz = raw.vibration_hz};
    }
    return sensors;
  }

  void write_drives() RT_SAFE {
    for (std::size_t c = 0; c < static_cast<std::size_t>(output.channel_count); ++c) {
      const channels::ChannelOutput& channel = output.channels[c];
      const std::vector<int>& axes = options.file.machine.channels[c].axes;
      for (std::size_t k = 0; k < axes.size(); ++k) {
        drives::DriveTarget& target = targets[static_cast<std::size_t>(axes[k])];
        target.position = channel.axes[k].position;
        target.velocity = channel.axes[k].velocity_demand;
        target.mode = channel.drives[k].follows_velocity
                          ? drives::OperationMode::cyclic_synchronous_velocity
                          : drives::OperationMode::cyclic_synchronous_position;
        target.enabled = channel.drives[k].enabled;
        target.brake_closed = channel.drives[k].brake_closed;
        target.position_accepted = channel.drives[k].reference.accepted;
        target.position_offset = channel.drives[k].reference.offset;
      }
    }
    turn_spindles();
    carry_out_fault_resets();
    bus->write({targets.data(), drive_count});
  }

  // The channel that turns a spindle has it; one that has come to rest is switched off.
  void turn_spindles() RT_SAFE {
    for (std::size_t k = axis_count; k < drive_count; ++k) {
      drives::DriveTarget& target = targets[k];
      target.velocity = spindle_speed(bus_drives[k].spindle);
      target.mode = drives::OperationMode::cyclic_synchronous_velocity;
      const bool turns = std::abs(raw_feedback[k].velocity) > spindle_rest_rev_per_min;
      target.enabled = target.velocity != 0.0 || (target.enabled && turns);
      target.brake_closed = false;
    }
  }

  [[nodiscard]] double spindle_speed(int id) const RT_SAFE {
    for (std::size_t c = 0; c < static_cast<std::size_t>(output.channel_count); ++c) {
      for (const channels::SpindleSetpoint& spindle : output.channels[c].process.spindles) {
        if (spindle.id == id && spindle.rev_per_min != 0.0) return spindle.rev_per_min;
      }
    }
    return 0.0;
  }

  // Who resets a channel or switches the machine on wants its drives back: the faults they stand in
  // are acknowledged, with the drive switched off meanwhile.
  void note_fault_resets(std::span<const channels::OperatorEvent> events) RT_SAFE {
    using channels::OperatorAction;
    for (const channels::OperatorEvent& event : events) {
      const bool is_reset = event.action() == OperatorAction::program_reset;
      if (!is_reset && event.action() != OperatorAction::machine_on) continue;
      for (const channels::ChannelConfig& channel : options.file.machine.channels) {
        if (is_reset && channel.id != event.channel) continue;
        for (const int axis : channel.axes) demand_reset(static_cast<std::size_t>(axis));
        for (std::size_t k = axis_count; k < drive_count; ++k) {
          if (std::ranges::find(channel.spindles, bus_drives[k].spindle) != channel.spindles.end())
            demand_reset(k);
        }
      }
    }
  }

  void demand_reset(std::size_t drive) RT_SAFE {
    if (raw_feedback[drive].state == drives::DriveState::fault)
      fault_reset_cycles[drive] = reset_cycles;
  }

  void carry_out_fault_resets() RT_SAFE {
    for (std::size_t k = 0; k < drive_count; ++k) {
      if (reset_demands[k].exchange(false, std::memory_order_relaxed)) demand_reset(k);
      targets[k].fault_reset = fault_reset_cycles[k] > 0;
      if (fault_reset_cycles[k] == 0) continue;
      --fault_reset_cycles[k];
      targets[k].enabled = false;
    }
  }

  AssemblyOptions options;
  TextBook texts;
  ProgramFiles files;
  ForceControls force_controls;
  channels::Machine machine;
  std::unique_ptr<ProcessPlant> process_plant;
  std::unique_ptr<OutputBook> outputs;
  std::size_t axis_count;
  std::size_t drive_count = 0;  // axes, then spindles with a drive
  std::vector<drives::AxisDriveConfig> bus_drives;
  std::vector<plant::SimulatedDriveConfig> simulated;  // in the order of the bus
  std::unique_ptr<plant::ModbusServer> server;
  std::unique_ptr<drives::DriveBus> bus;
  plant::DirectBus* direct = nullptr;  // `bus`, of simulated drives on the clock of the cycle
  channels::CycleOutput output;
  Signals inputs;
  bool has_signals = false;
  std::array<drives::DriveFeedback, drives_of_machine_max> raw_feedback{};
  std::array<channels::AxisFeedback, axes_of_machine_max> feedback{};
  std::array<drives::DriveTarget, drives_of_machine_max> targets{};
  std::vector<channels::SpindleSensors> sensors;  // of the spindles of the machine
  std::vector<int> spindle_drives;                // their places on the bus; -1: none
  std::array<std::atomic<bool>, drives_of_machine_max> reset_demands{};  // of operators
  std::array<int, drives_of_machine_max> fault_reset_cycles{};  // still to go with the demand
  int reset_cycles = 0;
};

Assembly::Assembly(AssemblyOptions options) : parts_(std::make_unique<Parts>(std::move(options))) {}

Assembly::~Assembly() {
  stop();
}

channels::Machine& Assembly::machine() {
  return parts_->machine;
}

const config::MachineFile& Assembly::file() const {
  return parts_->options.file;
}

void Assembly::start() {
  if (parts_->bus) parts_->bus->start();
}

void Assembly::stop() {
  if (parts_->bus) parts_->bus->stop();
  if (parts_->server) parts_->server->stop();
}

const channels::CycleOutput& Assembly::cycle(std::span<const channels::OperatorEvent> events,
                                             std::span<const channels::SpindleSensors> sensors)
    RT_SAFE {
  Parts& parts = *parts_;
  channels::CycleInputs inputs{.events = events, .feedback = {}, .sensors = sensors};
  if (parts.process_plant && !parts.bus && sensors.empty())
    inputs.sensors = parts.process_plant->sensors();
  if (parts.bus) {
    parts.read_drives();
    parts.note_fault_resets(events);
    inputs.feedback = {parts.feedback.data(), parts.axis_count};
    if (sensors.empty()) inputs.sensors = parts.read_sensors();
  }
  inputs.signals = parts.read_signals();
  parts.machine.cycle(inputs, parts.output);
  if (parts.process_plant) parts.process_plant->advance(parts.output);
  if (parts.bus) {
    if (parts.process_plant) parts.load_spindle();
    parts.write_drives();
    parts.write_signals();
  }
  if (parts.outputs) parts.outputs->note(parts.output);
  return parts.output;
}

const ProcessPlant* Assembly::process_plant() const RT_SAFE {
  return parts_->process_plant.get();
}

std::span<const channels::AxisFeedback> Assembly::feedback() const RT_SAFE {
  if (!parts_->bus) return {};
  return {parts_->feedback.data(), parts_->axis_count};
}

std::vector<recording::ProgramRead> Assembly::program_reads() {
  return parts_->texts.take();
}

Ring<channels::CycleOutput>& Assembly::outputs() {
  return parts_->outputs->outputs();
}

std::uint64_t Assembly::outputs_lost() const RT_SAFE {
  return parts_->outputs ? parts_->outputs->lost() : 0;
}

DriveChoice Assembly::drives() const {
  return parts_->options.drives;
}

drives::BusStatus Assembly::drive_status() const {
  return parts_->bus ? parts_->bus->status() : drives::BusStatus{};
}

bool Assembly::reset_drive(std::string_view drive) {
  const auto& drives = parts_->bus_drives;
  const auto found = std::ranges::find(drives, drive, &drives::AxisDriveConfig::axis);
  if (found == drives.end()) return false;
  parts_->reset_demands[static_cast<std::size_t>(found - drives.begin())] = true;
  return true;
}

bool Assembly::inject_fault(std::string_view drive, plant::FaultKind fault) {
  const auto& drives = parts_->simulated;
  const auto found = std::ranges::find_if(
      drives, [&](const plant::SimulatedDriveConfig& one) { return one.registers.axis == drive; });
  if (found == drives.end()) return false;
  const auto index = static_cast<std::size_t>(found - drives.begin());
  parts_->direct != nullptr ? parts_->direct->inject(index, fault)
                            : parts_->server->inject(index, fault);
  return true;
}

}  // namespace stanok::runtime
