#include "client/offline/simulate/simulate_library.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/utf8.h"
#include "client/offline/library/diagnostic_record.h"
#include "client/offline/library/record.h"
#include "client/offline/library/whole_file.h"
#include "client/offline/simulate/part_pictures.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "client/terminal/text_table.h"
#include "config/files/machine_file.h"
#include "runtime/program_files.h"
#include "runtime/simulation.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

// Notes the texts that a run reads.
class ReadNotes final : public runtime::CycleObserver {
 public:
  explicit ReadNotes(runtime::TextBook& book) : book_(book) {}
  using CycleObserver::observe;
  void observe(const channels::CycleOutput& /*output*/) override {}
  void observe(const recording::ProgramRead& read, std::int64_t /*cycle*/) override {
    book_.note(read);
  }

 private:
  runtime::TextBook& book_;
};

std::vector<std::filesystem::path> roots_of(const Candidate& candidate, const JobOptions& job) {
  std::vector<LocatedProgram> roots{locate(candidate.path)};
  if (!candidate.folder.empty()) roots.push_back({"", candidate.folder});
  return search_roots(roots, job);
}

Diagnostic diagnostic(const char* code, Severity severity, std::string message) {
  Diagnostic made;
  made.code = code;
  made.severity = severity;
  made.message = std::move(message);
  return made;
}

// "E6025 channel 1 ...": a code, and the text behind it.
Diagnostic refusal(const std::string& text) {
  const std::size_t blank = text.find(' ');
  Diagnostic made;
  made.code = text.substr(0, blank);
  made.message = blank == std::string::npos ? text : text.substr(blank + 1);
  return made;
}

Diagnostics found_in(const runtime::SimulationResult& result, double limit_s) {
  Diagnostics found;
  for (const auto& report : result.load_diagnostics) found.push_back(report.diagnostic);
  for (const auto& report : result.alarms) {
    if (result.load_diagnostics.empty() || report.diagnostic.place.line > 0)
      found.push_back(report.diagnostic);
  }
  if (result.load_diagnostics.empty()) {
    for (const std::string& text : result.refusals) found.push_back(refusal(text));
  }
  if (result.until_reached) {
    found.push_back(diagnostic(
        "W821", Severity::warning,
        fmt::format("the run was ended after {} s of machine time, the limit", limit_s)));
  }
  return found;
}

SimulatedProgram simulated(const Candidate& candidate, const LibrarySimulation& wanted,
                           const config::MachineFile& machine, runtime::TextBook& book) {
  const std::string name = locate(candidate.path).name;
  runtime::SimulationOptions options;
  options.file = machine;
  options.schemes = scheme_choices(wanted.job);
  options.until_s = wanted.limit_s;
  if (wanted.drives) options.drives = runtime::DriveChoice::simulated;
  options.programs.push_back({wanted.job.channel, name});
  options.program_roots = roots_of(candidate, wanted.job);
  ReadNotes notes(book);
  std::optional<PartPictures> pictures;
  if (!wanted.pictures.empty()) {
    pictures.emplace(machine, wanted.workpiece_memory_mib);
    options.workpieces = pictures->workpieces();
  }
  const auto result = runtime::simulate(options, {&notes}, [] { return false; });
  SimulatedProgram program{.file = candidate.path, .ok = result.ok};
  for (const channels::RunReport& run : result.runs) {
    program.blocks += run.blocks;
    program.path_mm += run.path_mm;
  }
  program.time_s = result.machine_time_s;
  program.diagnostics = found_in(result, wanted.limit_s);
  if (pictures) {
    program.pictures = pictures->drawn(result.runs);
    const Diagnostics& complaints = pictures->complaints();
    program.diagnostics.insert(program.diagnostics.end(), complaints.begin(), complaints.end());
  }
  for (Diagnostic& found : program.diagnostics) {
    if (found.place.file == name) found.place.file = candidate.path;
  }
  return program;
}

std::string record_of_program(const SimulatedProgram& program) {
  return bytes_of({{"file", program.file},
                   {"ok", program.ok},
                   {"blocks", program.blocks},
                   {"time_s", program.time_s},
                   {"path_mm", program.path_mm},
                   {"pictures", program.pictures},
                   {"diagnostics", diagnostics_record(program.diagnostics)}});
}

SimulatedProgram program_of(const std::string& bytes) {
  const json record = record_in(bytes).value_or(json());
  return {.file = record.at("file"),
          .ok = record.at("ok"),
          .blocks = record.at("blocks"),
          .time_s = record.at("time_s"),
          .path_mm = record.at("path_mm"),
          .diagnostics = diagnostics_of(record.at("diagnostics")),
          .pictures = record.at("pictures")};
}

// A program whose run ended the process that did it.
SimulatedProgram lost_simulation(const Candidate& candidate, const std::string& death) {
  Diagnostic found = diagnostic("E8006", Severity::error,
                                "the run of " + candidate.path + " ended its process: " + death);
  found.place.file = candidate.path;
  found.help = {"this is a fault of stanok: report it, with the program"};
  return {.file = candidate.path, .diagnostics = {std::move(found)}};
}

// A picture that fails is no fault of its program, as where one program is simulated.
int exit_code_with(const Diagnostic& found) {
  const bool is_of_picture = found.severity == Severity::error && found.code.starts_with("E92");
  return is_of_picture ? exit_failed : exit_code_of(found);
}

// Bytes become files: what could not be written is a fault of the program's.
void write_pictures(SimulatedProgram& program, const std::filesystem::path& first) {
  std::vector<std::string> files;
  for (std::size_t k = 0; k < program.pictures.size(); ++k) {
    const std::string file = numbered(first.string(), k + 1);
    if (program.pictures[k].empty()) continue;  // told of when it was drawn
    if (write_whole(file, program.pictures[k])) {
      files.push_back(file);
    } else {
      program.diagnostics.push_back(
          diagnostic("E9204", Severity::error, file + ": cannot be written"));
    }
  }
  program.pictures = std::move(files);
}

std::vector<std::string> questions_of(const LibrarySimulation& wanted) {
  std::vector<std::string> asked{"simulate", std::to_string(wanted.job.channel),
                                 std::to_string(wanted.limit_s), std::to_string(wanted.drives),
                                 wanted.job.program_root};
  asked.insert(asked.end(), wanted.job.schemes.begin(), wanted.job.schemes.end());
  if (!wanted.pictures.empty())
    asked.push_back("pictures " + std::to_string(wanted.workpiece_memory_mib));
  return asked;
}

struct SimulationTotals {
  std::size_t failed = 0;
  std::uint64_t blocks = 0;
  double time_s = 0.0;
  double path_mm = 0.0;
};

SimulationTotals simulation_totals(const std::vector<SimulatedProgram>& programs) {
  SimulationTotals sum;
  for (const SimulatedProgram& program : programs) {
    if (!program.ok) ++sum.failed;
    sum.blocks += program.blocks;
    sum.time_s += program.time_s;
    sum.path_mm += program.path_mm;
  }
  return sum;
}

std::string outcome_of(const SimulatedProgram& program) {
  if (program.ok) return "ok";
  return program.diagnostics.empty() ? "failed" : program.diagnostics.front().code;
}

}  // namespace

std::string simulated_table(const std::vector<SimulatedProgram>& programs,
                            const Terminal& terminal) {
  TextTable table({"program", "blocks", "time, s", "path, mm", "result"});
  const auto add = [&](const std::string& name, std::uint64_t blocks, double time_s, double path_mm,
                       const std::string& outcome) {
    table.add_row({name, std::to_string(blocks), fmt::format("{:.3f}", time_s),
                   fmt::format("{:.3f}", path_mm), outcome});
  };
  for (const SimulatedProgram& program : programs) {
    add(valid_utf8(program.file), program.blocks, program.time_s, program.path_mm,
        outcome_of(program));
  }
  const SimulationTotals sum = simulation_totals(programs);
  add(std::to_string(programs.size()) + " programs", sum.blocks, sum.time_s, sum.path_mm,
      std::to_string(sum.failed) + " failed");
  return table.text(terminal);
}

ordered_json simulated_json(const std::vector<SimulatedProgram>& programs) {
  ordered_json all;
  all["files"] = ordered_json::array();
  for (const SimulatedProgram& program : programs) {
    ordered_json one{{"file", program.file},
                     {"ok", program.ok},
                     {"blocks", program.blocks},
                     {"time_s", program.time_s},
                     {"path_mm", program.path_mm}};
    if (!program.pictures.empty()) one["pictures"] = program.pictures;
    one["diagnostics"] = ordered_json::array();
    for (const Diagnostic& found : program.diagnostics)
      one["diagnostics"].push_back(to_json(found));
    all["files"].push_back(std::move(one));
  }
  const SimulationTotals sum = simulation_totals(programs);
  all["totals"] = {{"programs", programs.size()},
                   {"failed", sum.failed},
                   {"blocks", sum.blocks},
                   {"time_s", sum.time_s},
                   {"path_mm", sum.path_mm}};
  return all;
}

LibraryWork simulation_work(const LibrarySimulation& wanted) {
  const auto machine = std::make_shared<const config::MachineFile>(
      config::read_machine_file(wanted.job.machine_file));
  return {.result =
              [wanted, machine](const Candidate& candidate, runtime::TextBook& book) {
                return record_of_program(simulated(candidate, wanted, *machine, book));
              },
          .files =
              [wanted, machine](const Candidate& candidate) {
                return std::make_unique<runtime::ProgramFiles>(
                    roots_of(candidate, wanted.job), runtime::program_format(machine->machine));
              },
          .context = [wanted, machine] { return context_of(*machine, questions_of(wanted)); }};
}

LibraryOutput simulation_output(const LibrarySimulation& wanted) {
  const auto programs = std::make_shared<std::vector<SimulatedProgram>>();
  const auto take = [=](const Candidate& candidate, const std::string& result,
                        const std::string& death) {
    programs->push_back(death.empty() ? program_of(result) : lost_simulation(candidate, death));
    write_pictures(programs->back(), picture_of(candidate, wanted.pictures));
    if (wanted.job.json) return;
    for (const Diagnostic& found : programs->back().diagnostics) print(found);
  };
  const auto finish = [=] {
    if (wanted.job.json) {
      write_json(simulated_json(*programs));
    } else {
      write_data(simulated_table(*programs, Terminal(STDOUT_FILENO)));
    }
    int exit_code = 0;
    for (const SimulatedProgram& program : *programs) {
      if (!program.ok) exit_code = std::max(exit_code, exit_failed);
      for (const Diagnostic& found : program.diagnostics)
        exit_code = std::max(exit_code, exit_code_with(found));
    }
    return exit_code;
  };
  return {.take = take, .finish = finish};
}

}  // namespace stanok::client
