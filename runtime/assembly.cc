#include "runtime/assembly.h"

#include <stdexcept>
#include <utility>

#include "runtime/clock_gaps.h"
#include "runtime/drive_side/drive_exchange.h"
#include "runtime/drive_side/program_inputs.h"
#include "runtime/drive_side/steady_feedback.h"
#include "runtime/force_controls.h"
#include "runtime/output_book.h"
#include "runtime/program_files.h"

namespace stanok::runtime {
namespace {

bool simulates_a_cut(const AssemblyOptions& options) {
  return options.drives != DriveChoice::real && !options.file.simulation.cutting.stock.empty();
}

std::span<const config::SimulatedContact> contacts_of(const AssemblyOptions& options) {
  if (options.drives == DriveChoice::real) return {};
  return options.file.contacts;
}

// What it has too many of does not fit into the cycle.
AssemblyOptions checked(AssemblyOptions options) {
  if (options.file.machine.axes.size() > axes_of_machine_max) {
    throw std::invalid_argument(options.file.machine.file + ": more than " +
                                std::to_string(axes_of_machine_max) + " axes");
  }
  return options;
}

}  // namespace

struct Assembly::Parts {
  explicit Parts(AssemblyOptions given)
      : options(checked(std::move(given))),
        files(options.program_roots, program_format(options.file.machine), &texts),
        force_controls(options.file),
        machine(options.file.machine, files, force_controls.given_to(options.machine)),
        process_plant(simulates_a_cut(options) ? std::make_unique<ProcessPlant>(options.file)
                                               : nullptr),
        drives(
            make_drive_side(options.drives, {options.file, options.machine, process_plant.get()})),
        inputs(contacts_of(options), options.machine),
        gaps(options.file.machine),
        steady(options.file.machine, options.file.bus) {
    if (options.output_capacity > 0)
      outputs = std::make_unique<OutputBook>(options.output_capacity, machine.events());
  }

  // What the next cycle is given.
  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() RT_SAFE {
    given = drives->feedback();
    if (options.steady_at_rest) given = steady.of(given, output);
    return given;
  }

  AssemblyOptions options;
  TextBook texts;
  ProgramFiles files;
  ForceControls force_controls;
  channels::Machine machine;
  std::unique_ptr<ProcessPlant> process_plant;
  std::unique_ptr<DriveSide> drives;
  ProgramInputs inputs;
  ClockGaps gaps;
  SteadyFeedback steady;
  channels::ClockGap gap;  // before the next cycle
  std::unique_ptr<OutputBook> outputs;
  channels::CycleOutput output;
  std::span<const channels::AxisFeedback> given;  // of the latest cycle
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
  parts_->drives->start();
}

void Assembly::stop() {
  parts_->drives->stop();
}

const channels::CycleOutput& Assembly::cycle(std::span<const channels::OperatorEvent> events,
                                             std::span<const channels::SpindleSensors> sensors,
                                             const Signals* touched) RT_SAFE {
  Parts& parts = *parts_;
  DriveSide& drives = *parts.drives;
  drives.read(events);
  compute({.events = events,
           .feedback = parts.feedback(),
           .signals = parts.inputs.read(drives, parts.output, touched),
           .sensors = sensors.empty() ? drives.sensors() : sensors,
           .gap = std::exchange(parts.gap, {})});
  drives.write(parts.output);
  return parts.output;
}

const channels::CycleOutput& Assembly::late_cycle(std::int64_t lost,
                                                  std::span<const channels::OperatorEvent> events)
    RT_SAFE {
  Parts& parts = *parts_;
  parts.gap = parts.gaps.gap_of(lost, parts.machine);
  const std::int64_t carried = parts.gap.carried;
  for (std::int64_t k = 0; k < carried; ++k) carry_on();
  parts.drives->pass(lost);
  return cycle(events);
}

// A cycle with what is known already; nothing is sent.
void Assembly::carry_on() RT_SAFE {
  Parts& parts = *parts_;
  compute({.events = {},
           .feedback = parts.feedback(),
           .signals = parts.inputs.latest(),
           .sensors = parts.drives->sensors(),
           .gap = std::exchange(parts.gap, {})});
}

void Assembly::compute(const channels::CycleInputs& inputs) RT_SAFE {
  Parts& parts = *parts_;
  parts.machine.cycle(inputs, parts.output);
  if (parts.process_plant) parts.process_plant->advance(parts.output);
  if (parts.outputs) parts.outputs->note(parts.output);
}

double Assembly::position_of(int axis) const RT_SAFE {
  return parts_->drives->position_of(axis, parts_->output);
}

const ProcessPlant* Assembly::process_plant() const RT_SAFE {
  return parts_->process_plant.get();
}

std::span<const channels::AxisFeedback> Assembly::feedback() const RT_SAFE {
  return parts_->given;
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
  return parts_->drives->status();
}

bool Assembly::reset_drive(std::string_view drive) {
  return parts_->drives->reset_drive(drive);
}

bool Assembly::inject_fault(std::string_view drive, plant::FaultKind fault) {
  return parts_->drives->inject_fault(drive, fault);
}

}  // namespace stanok::runtime
