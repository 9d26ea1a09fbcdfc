// runtime::simulate for Python: setpoints in columns, what happened as a list.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "protocol/contract/json_text.h"
#include "protocol/contract/version.h"
#include "python/native/bindings.h"
#include "python/native/faults.h"
#include "python/native/interruption.h"
#include "python/native/machine_handle.h"
#include "python/native/setpoint_columns.h"
#include "recording/format/encode.h"
#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "runtime/simulation_files/operator_events_file.h"
#include "runtime/simulation_files/sensor_file.h"

namespace stanok::python {
namespace {

namespace py = pybind11;
using channels::RunReport;
using nlohmann::ordered_json;

// What is kept of a run.
struct Kept {
  std::vector<std::string> columns;
  std::int64_t every = 1;  // cycle
};

// Keeps the setpoints of all channels and what happened.
class Memory final : public runtime::CycleObserver {
 public:
  Memory(const channels::MachineConfig& machine, const Kept& kept)
      : cycle_us_(machine.cycle_us), every_(kept.every) {
    for (const channels::ChannelConfig& channel : machine.channels)
      columns_.try_emplace(channel.id, kept.columns);
  }

  void observe(const channels::CycleOutput& output) override {
    if (cycles_++ % every_ != 0) return;
    for (const channels::ChannelOutput& channel : output.of_channels()) {
      const std::int64_t utime = output.cycle * cycle_us_;
      const recording::Stamp stamp{.utime = utime, .cycle = output.cycle, .seq = cycles_ - 1};
      columns_.at(channel.id)
          .add(recording::to_setpoint(channel, stamp), static_cast<double>(utime) * 1e-6);
    }
  }
  void observe(const channels::Event& event) override { events_.push_back(event); }

  [[nodiscard]] py::dict take_setpoints() {
    py::dict channels;
    for (auto& [id, columns] : columns_) channels[py::int_(id)] = columns.take();
    return channels;
  }

  [[nodiscard]] ordered_json events_json(const std::vector<RunReport>& runs) const {
    ordered_json list = ordered_json::array();
    for (const channels::Event& event : events_) {
      list.push_back({{"cycle", event.cycle},
                      {"time_s", static_cast<double>(event.cycle * cycle_us_) * 1e-6},
                      {"channel", event.channel},
                      {"code", std::string(event.code.view())},
                      {"text", std::string(event.text.view())},
                      {"file", file_of(event, runs)},
                      {"line", event.tag.line}});
    }
    return list;
  }

 private:
  [[nodiscard]] static std::string file_of(const channels::Event& event,
                                           const std::vector<RunReport>& runs) {
    if (event.tag.line == 0) return "";
    for (const RunReport& run : runs) {
      const bool is_of_event = run.channel == event.channel && run.run == event.tag.run;
      if (is_of_event && event.tag.file < run.files.size()) return run.files[event.tag.file];
    }
    return "";
  }

  std::int64_t cycle_us_;
  std::int64_t every_;
  std::int64_t cycles_ = 0;
  std::map<int, SetpointColumns> columns_;  // by id of the channel
  std::vector<channels::Event> events_;
};

ordered_json by_word(const std::vector<std::string>& words, const motion::Point& point) {
  ordered_json json = ordered_json::object();
  for (std::size_t k = 0; k < words.size(); ++k) json[words[k]] = point[k];
  return json;
}

ordered_json run_json(const RunReport& run, const channels::ChannelConfig& channel,
                      double cycle_s) {
  return {{"channel", run.channel},
          {"number", run.run},
          {"program", run.program},
          {"files", run.files},
          {"ok", run.ok},
          {"ended", run.ended},
          {"blocks", run.blocks},
          {"start_cycle", run.start_cycle},
          {"end_cycle", run.end_cycle},
          {"time_s", static_cast<double>(run.end_cycle - run.start_cycle) * cycle_s},
          {"path_mm", run.path_mm},
          {"end", by_word(channel.words, run.end_W)},
          {"end_axes", by_word(channel.words, run.end_M)}};
}

// "E5201 channel 3 has no ...": a code of the catalogue and what it says here.
ordered_json refusal_json(const std::string& refusal) {
  const std::size_t blank = refusal.find(' ');
  if (blank == std::string::npos) return fault_json("", refusal);
  return fault_json(refusal.substr(0, blank), refusal.substr(blank + 1));
}

ordered_json alarms_json(const std::vector<channels::AlarmReport>& reports) {
  ordered_json list = ordered_json::array();
  for (const channels::AlarmReport& report : reports) {
    list.push_back(fault_json(report.diagnostic));
    list.back()["channel"] = report.channel;
    list.back()["cycle"] = report.cycle;
  }
  return list;
}

ordered_json process_json(const std::optional<runtime::SimulationResult::Process>& process) {
  if (!process) return nullptr;
  return {{"force_error_steady_max", process->force_error_steady_max},
          {"overshoot_return_max", process->overshoot_return_max},
          {"settling_s", process->settling_s}};
}

ordered_json result_json(const runtime::SimulationResult& result, const Memory& memory,
                         const config::MachineFile& machine) {
  ordered_json json = {{"ok", result.ok},
                       {"until_reached", result.until_reached},
                       {"cycle_s", result.cycle_s},
                       {"cycles", result.cycles},
                       {"machine_time_s", result.machine_time_s},
                       {"wall_s", result.wall_s},
                       {"process", process_json(result.process)},
                       {"refused_events", result.refused_events},
                       {"load_faults", alarms_json(result.load_diagnostics)},
                       {"alarms", alarms_json(result.alarms)},
                       {"events", memory.events_json(result.runs)}};
  json["refusals"] = ordered_json::array();
  for (const std::string& refusal : result.refusals)
    json["refusals"].push_back(refusal_json(refusal));
  json["runs"] = ordered_json::array();
  for (const RunReport& run : result.runs)
    json["runs"].push_back(run_json(run, channel_of(machine, run.channel), result.cycle_s));
  return json;
}

// Who is told of what: an event of the list by its number from 0.
std::vector<runtime::TimedEvent> timed_events(const std::vector<std::string>& texts) {
  std::vector<runtime::TimedEvent> events;
  for (const std::string& text : texts) {
    try {
      events.push_back(runtime::timed_event(text));
    } catch (const std::exception& reason) {
      throw std::invalid_argument("event " + std::to_string(events.size()) + ", " + text + ": " +
                                  reason.what());
    }
  }
  runtime::sort_events(events);
  return events;
}

// What is simulated, as Python names it.
struct Job {
  std::vector<std::pair<int, std::string>> programs;  // channel, name
  Roots roots;
  std::vector<std::string> events;           // JSON
  std::vector<std::pair<int, int>> schemes;  // channel, scheme
  double until_s = -1.0;
  bool drives = false;
  std::string sensors;  // file; empty: none
  std::string log;      // file to write; empty: none
};

runtime::SimulationOptions options_of(const config::MachineFile& machine, const Job& job) {
  runtime::SimulationOptions options;
  options.file = machine;
  options.program_roots = job.roots;
  for (const auto& [channel, program] : job.programs) {
    static_cast<void>(channel_of(machine, channel));
    options.programs.push_back({channel, program});
  }
  options.schemes = job.schemes;
  options.events = timed_events(job.events);
  if (!job.sensors.empty())
    options.sensors = runtime::read_sensor_file(job.sensors, machine.machine.spindles);
  if (job.drives) options.drives = runtime::DriveChoice::simulated;
  options.until_s = job.until_s;
  return options;
}

// nullptr: none is wanted.
std::unique_ptr<runtime::LogObserver> log_of(const runtime::SimulationOptions& options,
                                             const std::string& file) {
  if (file.empty()) return nullptr;
  return std::make_unique<runtime::LogObserver>(options.file, runtime::setup_of(options), file,
                                                std::string(protocol::version));
}

py::tuple simulate(const config::MachineFile& machine, const Job& job, const Kept& kept) {
  const runtime::SimulationOptions options = options_of(machine, job);
  Memory memory(machine.machine, kept);
  const auto log = log_of(options, job.log);
  std::vector<runtime::CycleObserver*> observers{&memory};
  if (log != nullptr) observers.push_back(log.get());
  Interruption interruption;
  runtime::SimulationResult result;
  std::string text;
  std::string log_error;
  {
    const py::gil_scoped_release others_run;
    result = runtime::simulate(options, observers, interruption.asked());
    if (log != nullptr) log_error = log->close();
    text = protocol::json_text(result_json(result, memory, machine));
  }
  interruption.rethrow();
  if (!log_error.empty()) raise("LogError", ordered_json::array({fault_json("", log_error)}));
  return py::make_tuple(py::str(text), memory.take_setpoints());
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<Job>(module, "Job")
      .def(py::init<>())
      .def_readwrite("programs", &Job::programs)
      .def_readwrite("roots", &Job::roots)
      .def_readwrite("events", &Job::events)
      .def_readwrite("schemes", &Job::schemes)
      .def_readwrite("until_s", &Job::until_s)
      .def_readwrite("drives", &Job::drives)
      .def_readwrite("sensors", &Job::sensors)
      .def_readwrite("log", &Job::log);
  module.def("columns", &SetpointColumns::names);
  module.def(
      "simulate",
      [](const config::MachineFile& machine, const Job& job, std::vector<std::string> columns,
         std::int64_t every) {
        if (every < 1) throw std::invalid_argument("every must be 1 or more");
        return simulate(machine, job, {.columns = std::move(columns), .every = every});
      },
      py::arg("machine"), py::arg("job"), py::arg("columns"), py::arg("every"));
}

}  // namespace stanok::python
