#include "runtime/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "runtime/process_report.h"
#include "runtime/thread_time.h"

namespace stanok::runtime {
namespace {

// Steps of a preparation between two looks at `interrupted`.
constexpr int interruption_steps = 1024;

// Steps in which a preparation may compute without giving the cycle anything before the clock goes
// on, 20 million instructions. From then on it gets one step a cycle, until it gives something.
constexpr int computing_steps_max = 1000;

constexpr std::uint64_t first_event_id = 1'000'000;  // ids below are those of programs

// Reading the clock of the thread costs a third of a cycle: each of the first cycles is timed, then
// one in seven, which no period of polls or samples divides.
constexpr std::int64_t timed_cycles = 1000;
constexpr std::int64_t timing_interval = 7;

bool is_timed(std::int64_t cycle) {
  return cycle < timed_cycles || cycle % timing_interval == 0;
}

std::int64_t thread_time_ns() {
  return processor_time_of_thread().count();
}

// Recorded sensors stand for the simulated cut.
config::MachineFile file_without_replaced_plant(const SimulationOptions& options) {
  config::MachineFile file = options.file;
  if (!options.sensors.empty()) file.simulation.cutting.stock.clear();
  return file;
}

// Of a machine that can probe, or those that are wanted anyway.
std::shared_ptr<SimulatedWorkpieces> workpieces_of(const SimulationOptions& options) {
  if (options.workpieces || !SimulatedWorkpieces::can_probe(options.file))
    return options.workpieces;
  const auto leave_untold = [](int, const std::string&, const std::string&) {};
  return std::make_shared<SimulatedWorkpieces>(options.file, simulation::memory_default,
                                               leave_untold);
}

channels::MachineOptions machine_options(const SimulationOptions& options,
                                         const std::function<bool()>& interrupted) {
  channels::MachineOptions chosen = setup_of(options).options;
  chosen.gives_up = interrupted;
  chosen.changes_kept_s = options.file.machine.cycle_us * 1e-6;  // taken after each cycle
  return chosen;
}

class Simulation {
 public:
  Simulation(const SimulationOptions& options, const std::vector<CycleObserver*>& observers,
             const std::function<bool()>& interrupted)
      : options_(options),
        observers_(observers),
        assembly_({.file = file_without_replaced_plant(options),
                   .drives = options.drives,
                   .program_roots = options.program_roots,
                   .machine = machine_options(options, interrupted),
                   .output_capacity = 0}),
        machine_(assembly_.machine()),
        workpieces_(workpieces_of(options)),
        process_(options.file.machine.cycle_us * 1e-6),
        computing_steps_(options.file.machine.channels.size()),
        has_computed_(options.file.machine.channels.size()) {
    for (const auto& [channel, scheme] : options.schemes) {
      if (!machine_.select_scheme_at_start(channel, scheme)) {
        result_.refusals.push_back("E5201 channel " + std::to_string(channel) +
                                   " has no kinematic scheme " + std::to_string(scheme));
      }
    }
    result_.cycle_s = options.file.machine.cycle_us * 1e-6;
    for (CycleObserver* observer : observers) observer->begin(machine_);
  }

  SimulationResult run(const std::function<bool()>& interrupted) {
    const auto begin = std::chrono::steady_clock::now();
    start_programs();
    const auto cycles_until = std::llround(options_.until_s / result_.cycle_s);
    while (result_.refusals.empty()) {
      if (!prepare_all(interrupted)) break;
      if (events_.empty() && next_event_ == options_.events.size() && machine_.waits_for_operator())
        break;
      result_.until_reached = options_.until_s >= 0.0 && output_->cycle >= cycles_until;
      if (result_.until_reached) break;
      if (interrupted()) break;
      cycle();
    }
    result_.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report();
  }

 private:
  void start_programs() {
    for (const ChannelProgram& program : options_.programs) {
      channels::OperatorEvent event;
      event.id = events_.size() + 1;
      event.command =
          channels::commands::ProgramRun{channels::ShortText(std::string_view(program.program))};
      event.channel = program.channel;
      events_.push_back(event);
    }
  }

  // Until every preparation is blocked, or has computed for long. False: interrupted.
  bool prepare_all(const std::function<bool()>& interrupted) {
    std::fill(has_computed_.begin(), has_computed_.end(), false);
    bool worked = true;
    for (int steps = 1; worked;) {
      worked = false;
      for (std::size_t k = 0; k < computing_steps_.size(); ++k) {
        while (prepare_step(k)) {
          worked = true;
          if (steps++ % interruption_steps == 0 && interrupted()) return false;
        }
      }
    }
    return true;
  }

  // False: nothing more before the next cycle.
  bool prepare_step(std::size_t channel) {
    int& computing = computing_steps_[channel];
    if (computing > computing_steps_max && has_computed_[channel]) return false;
    const channels::Progress progress = machine_.prepare(static_cast<int>(channel));
    has_computed_[channel] = progress == channels::Progress::computing;
    computing = has_computed_[channel] ? computing + 1 : 0;
    return progress != channels::Progress::blocked && computing <= computing_steps_max;
  }

  void cycle() {
    while (next_event_ < options_.events.size() &&
           options_.events[next_event_].cycle <= output_->cycle + 1) {
      events_.push_back(options_.events[next_event_++].event);
      events_.back().id = first_event_id + next_event_;
    }
    const Signals* const touched = touched_inputs();
    if (is_timed(output_->cycle)) {
      const std::int64_t begin = thread_time_ns();
      output_ = &assembly_.cycle(events_, sensors_now(), touched);
      result_.cycle_time.add(thread_time_ns() - begin);
    } else {
      output_ = &assembly_.cycle(events_, sensors_now(), touched);
    }
    if (workpieces_) workpieces_->observe(*output_);
    events_.clear();
    report_process();
    hand_on();
  }

  [[nodiscard]] const Signals* touched_inputs() {
    if (!workpieces_) return nullptr;
    return workpieces_->touched(*output_, [this](int axis) { return assembly_.position_of(axis); });
  }

  // Reports the first channel that has force control.
  void report_process() {
    const auto begin = output_->channels.begin();
    const auto end = begin + output_->channel_count;
    const auto channel =
        std::find_if(begin, end, [](const auto& one) { return one.process.has_force_control; });
    if (channel == end) return;
    const ProcessPlant* const plant = assembly_.process_plant();
    if (plant != nullptr) {
      process_.add(*channel, plant->cut().force_n(), plant->cut().cut());
    } else {
      process_.add(*channel, channel->process.force.force_n,
                   {.depth_mm = channel->process.force.force_n > 0.0 ? 1.0 : 0.0});
    }
  }

  // The values of the latest row at the cycle to come; those of the drives where there are no rows.
  std::span<const channels::SpindleSensors> sensors_now() {
    const double t = static_cast<double>(output_->cycle + 1) * result_.cycle_s;
    while (next_sensors_ < options_.sensors.size() && options_.sensors[next_sensors_].t <= t)
      ++next_sensors_;
    if (next_sensors_ == 0) return {};
    return options_.sensors[next_sensors_ - 1].spindles;
  }

  void hand_on() {
    for (const recording::ProgramRead& read : assembly_.program_reads()) {
      for (CycleObserver* observer : observers_) observer->observe(read, output_->cycle);
    }
    channels::InputRecord input;
    while (machine_.input_records().pop(input)) {
      for (CycleObserver* observer : observers_) observer->observe(input);
    }
    channels::InputChange change;
    while (machine_.input_changes().pop(change)) {
      for (CycleObserver* observer : observers_) observer->observe(change);
    }
    for (CycleObserver* observer : observers_) observer->observe(*output_);
    channels::Event event;
    while (machine_.events().pop(event)) {
      // A cut without its force has not become the part, whatever the run says of itself.
      lacks_force_ = lacks_force_ || event.code.view() == "W615";
      for (CycleObserver* observer : observers_) observer->observe(event);
    }
    channels::OperatorReply reply;
    while (machine_.replies().pop(reply)) {
      if (reply.ok) continue;
      const std::string code(reply.code.view());
      const std::string text = code + (code.empty() ? "" : " ") + std::string(reply.text.view());
      (reply.id >= first_event_id ? result_.refused_events : result_.refusals).push_back(text);
    }
  }

  SimulationResult report() {
    result_.cycles = output_->cycle;
    result_.machine_time_s = static_cast<double>(output_->cycle) * result_.cycle_s;
    process_.finish();
    if (process_.has_any()) {
      result_.process = {.force_error_steady_max = process_.force_error_steady_max(),
                         .overshoot_return_max = process_.overshoot_return_max(),
                         .settling_s = process_.settling_s()};
    }
    result_.runs = machine_.runs();
    result_.alarms = machine_.alarms();
    result_.load_diagnostics = machine_.load_diagnostics();
    result_.ok = result_.refusals.empty() && result_.alarms.empty() && !result_.until_reached &&
                 machine_.is_idle() && !lacks_force_;
    for (const channels::RunReport& run : result_.runs) result_.ok = result_.ok && run.ok;
    if (result_.refusals.empty() && result_.alarms.empty() && !result_.until_reached)
      name_stuck_channels();
    return result_;
  }

  // Nobody resumes a held channel here; those that wait for it wait for ever.
  void name_stuck_channels() {
    for (const channels::ChannelOutput& channel : output_->of_channels()) {
      if (!channel.running) continue;
      const bool is_held = channel.state == channels::ChannelState::held;
      if (!is_held && !channel.waiting) continue;
      result_.refusals.push_back(
          "E6025 channel " + std::to_string(channel.id) + " in line " +
          std::to_string(channel.tag.line) +
          (is_held ? " stays held: " + std::string(channels::text_of(channel.hold_cause))
                   : " waits for channels that do not continue"));
    }
  }

  const SimulationOptions& options_;
  const std::vector<CycleObserver*>& observers_;
  Assembly assembly_;
  channels::Machine& machine_;
  std::shared_ptr<SimulatedWorkpieces> workpieces_;  // nullptr: nothing is cut
  ProcessReport process_;
  channels::CycleOutput before_first_{};
  const channels::CycleOutput* output_ = &before_first_;
  bool lacks_force_ = false;
  std::vector<channels::OperatorEvent> events_;
  std::vector<int> computing_steps_;  // by channel, without having given anything since
  std::vector<bool> has_computed_;    // by channel, since the latest cycle
  std::size_t next_event_ = 0;
  std::size_t next_sensors_ = 0;
  SimulationResult result_;
};

}  // namespace

RunSetup setup_of(const SimulationOptions& options) {
  return {.options = {.on_at_start = true,
                      .stops_go_on = true,
                      .outputs_to_inputs = options.file.simulation.outputs_to_inputs,
                      .reports_kept_max = std::numeric_limits<std::size_t>::max()},
          .schemes = options.schemes};
}

SimulationResult simulate(const SimulationOptions& options,
                          const std::vector<CycleObserver*>& observers,
                          const std::function<bool()>& interrupted) {
  return Simulation(options, observers, interrupted).run(interrupted);
}

}  // namespace stanok::runtime
