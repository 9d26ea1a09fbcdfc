#include "client/offline/simulate/simulate_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/utf8.h"
#include "client/offline/machine/job_options.h"
#include "client/offline/simulate/measurement_observer.h"
#include "client/offline/simulate/part_pictures.h"
#include "client/offline/simulate/simulate_library.h"
#include "client/offline/simulate/speed_limits.h"
#include "client/offline/workpiece/simulated_parts.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/output.h"
#include "client/terminal/progress_line.h"
#include "config/files/machine_file.h"
#include "protocol/contract/version.h"
#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "runtime/simulation_files/operator_events_file.h"
#include "runtime/simulation_files/sensor_file.h"
#include "runtime/trace_writer.h"

namespace stanok::client {
namespace {

// What belongs to several programs, each run by itself.
struct SeveralPrograms {
  LibraryOptions library;
  double limit_s = -1.0;  // of machine time of each
  std::string pictures;   // folder
};

struct SimulateOptions {
  JobOptions job;
  std::vector<std::string> programs;
  std::vector<std::string> runs;         // CH=FILE
  std::vector<std::string> tip_traces;   // CH=FILE.csv
  std::vector<std::string> axis_traces;  // CH=FILE.csv
  std::string log;
  std::string measurements;
  std::string events;
  std::string sensors;
  std::vector<std::string> why;  // lines
  WorkpieceOptions workpiece;
  double until_s = -1.0;
  SeveralPrograms several;
  bool drives = false;
};

// Progress on a terminal, four times a second: machine time, and where the programs are.
class SimulationProgress final : public runtime::CycleObserver {
 public:
  SimulationProgress(double cycle_s, ProgressLine& line) : cycle_s_(cycle_s), line_(line) {}
  ~SimulationProgress() override { line_.clear(); }

  void observe(const channels::CycleOutput& output) override {
    constexpr std::int64_t cycles_between_looks = 256;
    if (!line_.is_wanted() || output.cycle % cycles_between_looks != 0) return;
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(250);
    line_.show(text(output, std::chrono::duration<double>(now - begin_).count()));
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::string text(const channels::CycleOutput& output, double wall_s) const {
    std::string text = fmt::format("machine time {:.0f} s in {:.0f} s",
                                   static_cast<double>(output.cycle) * cycle_s_, wall_s);
    for (const channels::ChannelOutput& channel : output.of_channels()) {
      if (channel.running)
        text +=
            fmt::format("  channel {} {}:{}", channel.id, channel.program.view(), channel.tag.line);
    }
    return text;
  }

  double cycle_s_;
  ProgressLine& line_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_ + std::chrono::seconds(1);  // what is over by then needs none
};

nlohmann::ordered_json axis_values(const std::vector<std::string>& words,
                                   const motion::Point& point) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < words.size(); ++k) json[words[k]] = point[k];
  return json;
}

nlohmann::ordered_json run_json(const channels::RunReport& run,
                                const channels::ChannelConfig& channel, double cycle_s) {
  nlohmann::ordered_json json;
  json["program"] = run.program;
  json["ok"] = run.ok;
  json["blocks"] = run.blocks;
  json["time_s"] = static_cast<double>(run.end_cycle - run.start_cycle) * cycle_s;
  json["path_mm"] = run.path_mm;
  json["end"] = axis_values(channel.words, run.end_W);
  json["end_axes"] = axis_values(channel.words, run.end_M);
  json["max_lookahead_blocks"] = run.lookahead_max_blocks;
  return json;
}

nlohmann::ordered_json channel_json(const runtime::SimulationResult& result,
                                    const channels::ChannelConfig& channel) {
  nlohmann::ordered_json json;
  json["id"] = channel.id;
  json["time_s"] = 0.0;
  json["alarms"] = nlohmann::ordered_json::array();
  for (const channels::AlarmReport& alarm : result.alarms) {
    if (alarm.channel != channel.id) continue;
    json["alarms"].push_back({{"code", alarm.diagnostic.code},
                              {"text", alarm.diagnostic.message},
                              {"file", alarm.diagnostic.place.file},
                              {"line", alarm.diagnostic.place.line}});
  }
  double time_s = 0.0;
  json["runs"] = nlohmann::ordered_json::array();
  for (const channels::RunReport& run : result.runs) {
    if (run.channel != channel.id) continue;
    time_s += static_cast<double>(run.end_cycle - run.start_cycle) * result.cycle_s;
    json["runs"].push_back(run_json(run, channel, result.cycle_s));
  }
  json["time_s"] = time_s;
  return json;
}

double microseconds(std::int64_t nanoseconds) {
  return static_cast<double>(nanoseconds) * 1e-3;
}

nlohmann::ordered_json result_json(const runtime::SimulationResult& result,
                                   const channels::MachineConfig& machine) {
  nlohmann::ordered_json json;
  json["ok"] = result.ok;
  json["cycle_s"] = result.cycle_s;
  json["cycles"] = result.cycles;
  json["machine_time_s"] = result.machine_time_s;
  json["wall_s"] = result.wall_s;
  json["channels"] = nlohmann::ordered_json::array();
  for (const auto& channel : machine.channels)
    json["channels"].push_back(channel_json(result, channel));
  if (result.process) {
    json["process"] = {{"force_error_steady_max", result.process->force_error_steady_max},
                       {"overshoot_return_max", result.process->overshoot_return_max},
                       {"settling_s", result.process->settling_s}};
  }
  json["rt"]["cycle_us"] = {{"p50", microseconds(result.cycle_time.percentile(0.5))},
                            {"p99", microseconds(result.cycle_time.percentile(0.99))},
                            {"p999", microseconds(result.cycle_time.percentile(0.999))},
                            {"max", microseconds(result.cycle_time.max())}};
  return json;
}

void print_summary(const runtime::SimulationResult& result) {
  const Terminal terminal(STDOUT_FILENO);
  for (const channels::RunReport& run : result.runs) {
    write_data(fmt::format(
        "channel {}  {:28} {:8} blocks  {:10.3f} s  {:12.3f} mm  {}\n", run.channel,
        valid_utf8(run.program), run.blocks,
        static_cast<double>(run.end_cycle - run.start_cycle) * result.cycle_s, run.path_mm,
        terminal.coloured(run.ok ? "ok" : "failed", run.ok ? Colour::green : Colour::red)));
  }
  write_data(
      fmt::format("machine time {:.3f} s in {:.2f} s ({:.0f} times real time), cycle p50 {:.1f} us "
                  "p99.9 {:.1f} "
                  "us\n",
                  result.machine_time_s, result.wall_s, result.machine_time_s / result.wall_s,
                  microseconds(result.cycle_time.percentile(0.5)),
                  microseconds(result.cycle_time.percentile(0.999))));
}

// What the run says as it comes: messages of programs, and warnings of programs, of feeds that the
// axes cannot follow, of sensors. Faults are reported at the end, with their places.
class EventLines final : public runtime::CycleObserver {
 public:
  explicit EventLines(ProgressLine& progress) : progress_(progress) {}
  void observe(const channels::CycleOutput& /*output*/) override {}
  void observe(const channels::Event& event) override {
    const std::string code(event.code.view());
    if (!code.empty() && code.front() != 'W') return;
    const std::string kind = code.empty() ? "message" : "warning[" + code + "]";
    const std::string line = event.tag.line > 0 ? " line " + std::to_string(event.tag.line) : "";
    progress_.clear();
    write_message(
        fmt::format("{}: channel {}{}: {}\n",
                    terminal_.coloured(kind, code.empty() ? Colour::plain : Colour::yellow),
                    event.channel, line, event.text.view()));
  }

 private:
  ProgressLine& progress_;
  Terminal terminal_{STDERR_FILENO};
};

int outcome(const runtime::SimulationResult& result) {
  if (is_interrupted()) return exit_interrupted;
  if (result.until_reached) return exit_until_reached;
  int code = result.ok ? 0 : exit_failed;
  for (const auto* reports : {&result.load_diagnostics, &result.alarms}) {
    for (const auto& report : *reports) code = std::max(code, exit_code_of(report.diagnostic));
  }
  return code;
}

void take_programs(const SimulateOptions& given, runtime::SimulationOptions& options) {
  std::vector<LocatedProgram> programs;
  const auto add_program = [&](int channel, const std::string& file) {
    programs.push_back(locate(file));
    options.programs.push_back({channel, programs.back().name});
  };
  for (const std::string& program : given.programs) add_program(given.job.channel, program);
  for (const std::string& text : given.runs) {
    const auto [channel, file] = channel_assignment(text, "--run");
    add_program(channel, file);
  }
  if (options.programs.empty()) throw CLI::RequiredError("PROGRAM or --run");
  options.program_roots = search_roots(programs, given.job);
}

runtime::SimulationOptions simulation_options(const SimulateOptions& given) {
  runtime::SimulationOptions options;
  options.file = config::read_machine_file(given.job.machine_file);
  options.schemes = scheme_choices(given.job);
  options.until_s = given.until_s;
  if (given.drives) options.drives = runtime::DriveChoice::simulated;
  if (!given.events.empty()) options.events = runtime::read_operator_events(given.events);
  if (!given.sensors.empty())
    options.sensors = runtime::read_sensor_file(given.sensors, options.file.machine.spindles);
  take_programs(given, options);
  return options;
}

// `12` or `part.nc:12`.
AskedLine asked_line(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  AskedLine asked;
  if (colon != std::string::npos) asked.file = text.substr(0, colon);
  const char* const number = text.data() + (colon == std::string::npos ? 0 : colon + 1);
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(number, last, asked.line);
  if (error != std::errc{} || end != last || asked.line < 1) {
    throw CLI::ValidationError(
        "--why",
        "`" + text + "` is no line: give its number, FILE:NUMBER of a called file, or all");
  }
  return asked;
}

// Empty: all lines.
std::vector<AskedLine> asked_lines(const std::vector<std::string>& texts) {
  if (std::ranges::find(texts, "all") != texts.end()) return {};
  std::vector<AskedLine> asked;
  std::ranges::transform(texts, std::back_inserter(asked), asked_line);
  return asked;
}

// Who looks at the cycles of a run.
struct Observers {
  ProgressLine progress;
  std::vector<std::unique_ptr<runtime::CycleObserver>> lines_and_traces;
  std::unique_ptr<runtime::LogObserver> log;          // none: no log is written
  std::unique_ptr<SimulatedParts> parts;              // none: nothing is asked of them
  std::unique_ptr<MeasurementObserver> measurements;  // none: they are not wanted
  std::unique_ptr<SpeedLimits> limits;                // none: nobody asks why

  Observers(const SimulateOptions& given, const runtime::SimulationOptions& options) {
    const channels::MachineConfig& machine = options.file.machine;
    lines_and_traces.push_back(
        std::make_unique<SimulationProgress>(machine.cycle_us * 1e-6, progress));
    lines_and_traces.push_back(std::make_unique<EventLines>(progress));
    for (const std::string& text : given.tip_traces) {
      const auto [channel, file] = channel_assignment(text, "--tip-trace");
      lines_and_traces.push_back(std::make_unique<runtime::TipTrace>(machine, channel, file));
    }
    for (const std::string& text : given.axis_traces) {
      const auto [channel, file] = channel_assignment(text, "--axis-trace");
      lines_and_traces.push_back(std::make_unique<runtime::AxisTrace>(machine, channel, file));
    }
    if (!given.log.empty()) {
      log = std::make_unique<runtime::LogObserver>(options.file, runtime::setup_of(options),
                                                   given.log, std::string(protocol::version));
    }
    if (!given.measurements.empty())
      measurements = std::make_unique<MeasurementObserver>(given.measurements, machine.cycle_us);
    if (!given.why.empty()) limits = std::make_unique<SpeedLimits>(machine, asked_lines(given.why));
    if (given.workpiece.files.is_wanted() || runtime::SimulatedWorkpieces::can_probe(options.file))
      parts = std::make_unique<SimulatedParts>(options.file, given.workpiece);
  }

  [[nodiscard]] std::vector<runtime::CycleObserver*> all() const {
    std::vector<runtime::CycleObserver*> observers;
    observers.reserve(lines_and_traces.size() + 3);
    for (const auto& observer : lines_and_traces) observers.push_back(observer.get());
    if (log != nullptr) observers.push_back(log.get());
    if (measurements != nullptr) observers.push_back(measurements.get());
    if (limits != nullptr) observers.push_back(limits.get());
    return observers;
  }
};

void tell_faults(const runtime::SimulationResult& result) {
  for (const auto& report : result.load_diagnostics) print(report.diagnostic);
  for (const auto& report : result.alarms) {
    if (result.load_diagnostics.empty() || report.diagnostic.place.line > 0)
      print(report.diagnostic);
  }
  if (result.load_diagnostics.empty()) {
    for (const std::string& refusal : result.refusals) write_message("error: " + refusal + "\n");
  }
  for (const std::string& refused : result.refused_events)
    write_message("warning: an event of the operator was refused: " + refused + "\n");
}

void print_result(const SimulateOptions& given, const channels::MachineConfig& machine,
                  const runtime::SimulationResult& result, const Observers& observers) {
  const SimulatedParts* parts = given.workpiece.files.is_wanted() ? observers.parts.get() : nullptr;
  const SpeedLimits* limits = observers.limits.get();
  if (given.job.json) {
    nlohmann::ordered_json json = result_json(result, machine);
    if (parts != nullptr) json["workpieces"] = parts->json();
    if (limits != nullptr) json["why"] = limits->json(result.runs);
    write_json(json);
  } else {
    print_summary(result);
    if (parts != nullptr) parts->print_summary();
    if (limits != nullptr) write_data(limits->text(result.runs));
  }
}

bool is_one(const Candidates& candidates) {
  return candidates.named == ProgramsNamed::by_files && candidates.programs.size() == 1;
}

// Of several programs each run is by itself: what belongs to one run does not go with them.
void check_library(const CLI::App& command, const Candidates& candidates) {
  if (is_one(candidates)) {
    for (const char* option : {"--jobs", "--cache", "--limit", "--pictures"}) {
      if (command.count(option) == 0) continue;
      throw CLI::ValidationError(option, "belongs to several programs, or a folder of them");
    }
    return;
  }
  static constexpr std::array known{
      "PROGRAM",  "--machine", "--channel", "--scheme", "--program-root", "--json",
      "--drives", "--jobs",    "--cache",   "--limit",  "--pictures",     "--workpiece-memory"};
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool is_known = std::ranges::find(known, name) != known.end();
    if (option->count() == 0 || is_known) continue;
    throw CLI::ValidationError(name, "belongs to one run; name one program");
  }
}

int run_several(const SimulateOptions& given, const Candidates& candidates) {
  if (!given.several.pictures.empty()) check_pictures(candidates, given.several.pictures);
  const LibrarySimulation wanted{.job = given.job,
                                 .limit_s = given.several.limit_s,
                                 .drives = given.drives,
                                 .pictures = given.several.pictures,
                                 .workpiece_memory_mib = given.workpiece.memory_mib};
  return run_library(candidates, given.several.library, simulation_work(wanted),
                     simulation_output(wanted));
}

int run_one(const SimulateOptions& given) {
  runtime::SimulationOptions options = simulation_options(given);
  Observers observers(given, options);
  if (observers.parts) options.workpieces = observers.parts->workpieces();
  catch_interrupts();
  const auto result = runtime::simulate(options, observers.all(), [] { return is_interrupted(); });
  std::string log_error = observers.log == nullptr ? "" : observers.log->close();
  if (log_error.empty() && observers.measurements) log_error = observers.measurements->error();
  if (!log_error.empty()) write_message("error: " + log_error + "\n");
  observers.lines_and_traces.clear();
  tell_faults(result);
  const bool has_workpieces =
      observers.parts == nullptr ||
      observers.parts->finish(result.runs, is_interrupted() ? RunWas::interrupted : RunWas::whole);
  print_result(given, options.file.machine, result, observers);
  const int code = outcome(result);
  return code == 0 && (!log_error.empty() || !has_workpieces) ? exit_failed : code;
}

int run_simulation(const SimulateOptions& given, const CLI::App& command) {
  if (given.programs.empty()) return run_one(given);
  const Candidates candidates = candidates_of(given.programs);
  check_library(command, candidates);
  return is_one(candidates) ? run_one(given) : run_several(given, candidates);
}

}  // namespace

void add_simulate_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "run programs on a virtual clock");
  command
      ->add_option("PROGRAM", options->programs,
                   "part program; several programs, or folders of programs, are run one by one")
      ->type_name("FILE");
  add_job_options(*command, options->job);
  command->add_option("--run", options->runs, "CH=FILE: run FILE on channel CH; may be repeated")
      ->type_name("CH=FILE");
  command
      ->add_option("--tip-trace", options->tip_traces,
                   "CH=FILE.csv: write the programmed point of every cycle")
      ->type_name("CH=FILE");
  command
      ->add_option("--axis-trace", options->axis_traces,
                   "CH=FILE.csv: write the machine axes in every cycle")
      ->type_name("CH=FILE");
  command->add_option("--log", options->log, "write an LCM log of all setpoints, states and inputs")
      ->type_name("FILE");
  command
      ->add_option("--measurements", options->measurements,
                   "folder for what the programs measure and print: measurements.csv, "
                   "measurements.jsonl, printed.txt")
      ->type_name("FOLDER");
  command->add_option("--until", options->until_s, "stop after this machine time, s");
  command->add_flag("--drives", options->drives,
                    "run the simulated drives; without this option, drives are ideal");
  command
      ->add_option("--events", options->events, "file of operator events, one JSON object per line")
      ->type_name("FILE");
  command
      ->add_option("--sensors", options->sensors,
                   "CSV file of sensor values over machine time: t,power_w,vibration_um")
      ->type_name("FILE");
  command
      ->add_option("--why", options->why,
                   "show what limited the speed in these lines (12,15; sub.nc:7 in a called file), "
                   "and what would make them faster; all: in the lines that took longest")
      ->type_name("LINE|FILE:LINE|all")
      ->delimiter(',');
  add_workpiece_options(*command, options->workpiece);
  command
      ->add_option("--limit", options->several.limit_s,
                   "end each of several programs after this machine time, s (W821)")
      ->check(CLI::PositiveNumber)
      ->type_name("SECONDS");
  command
      ->add_option(
          "--pictures", options->several.pictures,
          "folder for pictures of what each of several programs leaves of its blank: NAME.nc.png")
      ->type_name("FOLDER");
  add_library_options(*command, options->several.library);
  command->callback(
      [options, command, &exit_code] { exit_code = run_simulation(*options, *command); });
}

}  // namespace stanok::client
