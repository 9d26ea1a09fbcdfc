// Simulation: the whole runtime on a virtual clock, as fast as the processor goes, repeatable to
// the bit.
//
// The same Machine, the same cycle as in the daemon; a cycle runs only when every preparation is
// blocked. Time is cycle x cycle time.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/histogram.h"
#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "runtime/assembly.h"
#include "runtime/run_setup.h"
#include "runtime/workpiece/simulated_workpieces.h"

namespace stanok::runtime {

struct ChannelProgram {
  int channel = 1;
  std::string program;
};

// An operator's event at a cycle (`--events`).
struct TimedEvent {
  std::int64_t cycle = 0;
  channels::OperatorEvent event;
};

// What the sensors of all spindles of the machine tell from a time on.
struct SensorRow {
  double t = 0.0;  // s
  std::vector<channels::SpindleSensors> spindles;
};

struct SimulationOptions {
  config::MachineFile file;
  std::vector<std::filesystem::path> program_roots;
  std::vector<ChannelProgram> programs;
  std::vector<std::pair<int, int>> schemes;  // channel, scheme at start
  std::vector<TimedEvent> events;            // ascending cycles
  std::vector<SensorRow> sensors;            // ascending times; instead of those of the drives
  DriveChoice drives = DriveChoice::ideal;   // or simulated
  double until_s = -1.0;                     // < 0: until all channels are idle
  // What is cut and measured; nullptr: the run has its own where the machine can probe.
  std::shared_ptr<SimulatedWorkpieces> workpieces;
};

struct SimulationResult {
  bool ok = false;
  bool until_reached = false;
  double cycle_s = 0.001;
  std::int64_t cycles = 0;
  double machine_time_s = 0.0;
  double wall_s = 0.0;
  std::vector<channels::RunReport> runs;
  std::vector<channels::AlarmReport> alarms;
  std::vector<channels::AlarmReport> load_diagnostics;
  std::vector<std::string> refusals;        // programs that did not start: code and reason
  std::vector<std::string> refused_events;  // of the operator, likewise
  // How force control held the force, where it did.
  struct Process {
    double force_error_steady_max = 0.0;  // relative
    double overshoot_return_max = 0.0;    // relative
    std::vector<double> settling_s{};     // of each disturbance
  };
  std::optional<Process> process;
  // Processor time of one cycle over all channels: of the first 1,000, and of every seventh later.
  Histogram cycle_time;
};

// What looks at every cycle: traces, logs. Events are those since the cycle before.
class CycleObserver {
 public:
  virtual ~CycleObserver() = default;
  // Before the first cycle; the machine lives as long as cycles come.
  virtual void begin(const channels::Machine& machine) { static_cast<void>(machine); }
  virtual void observe(const channels::CycleOutput& output) = 0;
  virtual void observe(const channels::Event& event) { static_cast<void>(event); }
  virtual void observe(const channels::InputRecord& input) { static_cast<void>(input); }
  virtual void observe(const channels::InputChange& change) { static_cast<void>(change); }
  virtual void observe(const recording::ProgramRead& read, std::int64_t cycle) {
    static_cast<void>(read);
    static_cast<void>(cycle);
  }
};

// What the run depends on before its first cycle.
[[nodiscard]] RunSetup setup_of(const SimulationOptions& options);

// Runs to the end. `interrupted` is asked in every cycle, which may take some 100 ms where a fine
// workpiece is cut; true ends the simulation where it is.
[[nodiscard]] SimulationResult simulate(const SimulationOptions& options,
                                        const std::vector<CycleObserver*>& observers,
                                        const std::function<bool()>& interrupted);

}  // namespace stanok::runtime
