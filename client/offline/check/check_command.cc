#include "client/offline/check/check_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "client/offline/check/check_report.h"
#include "client/offline/check/law_report.h"
#include "client/offline/machine/job_options.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/output.h"
#include "client/terminal/progress_line.h"
#include "config/files/machine_file.h"
#include "runtime/dry_run.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
  JobOptions job;
  std::vector<std::string> programs;
  bool estimate = false;
};

// A program to check and the folder that the operator named, if it was found there.
struct Candidate {
  std::string path;
  fs::path folder;
};

// Name ends of part programs, as CAM systems and editors write them.
constexpr std::array<std::string_view, 7> program_extensions{".nc",  ".ngc", ".cnc", ".gcode",
                                                             ".tap", ".mpf", ".spf"};

bool is_program(const fs::directory_entry& entry) {
  std::string extension = entry.path().extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return entry.is_regular_file() && std::find(program_extensions.begin(), program_extensions.end(),
                                              extension) != program_extensions.end();
}

std::vector<Candidate> programs_below(const std::string& folder) {
  std::vector<Candidate> found;
  const auto options = fs::directory_options::skip_permission_denied;
  for (const auto& entry : fs::recursive_directory_iterator(folder, options)) {
    if (is_program(entry)) found.push_back({entry.path().lexically_normal().string(), folder});
  }
  if (found.empty()) {
    throw CLI::ValidationError("PROGRAM", "no part program (.nc, .ngc, ...) in " + folder);
  }
  std::sort(found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b) { return a.path < b.path; });
  return found;
}

CheckedProgram checked(const Candidate& candidate, const JobOptions& job,
                       const channels::MachineConfig& machine) {
  const auto begin = std::chrono::steady_clock::now();
  const LocatedProgram program = locate(candidate.path);
  std::vector<LocatedProgram> roots{program};
  if (!candidate.folder.empty()) roots.push_back({"", candidate.folder});
  const runtime::ProgramFiles files(search_roots(roots, job), runtime::program_format(machine));
  auto result = runtime::check_program(machine, job.channel, scheme_of(job), program.name, files);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  if (!candidate.folder.empty()) {  // in a folder a name alone may be that of several programs
    for (Diagnostic& diagnostic : result.diagnostics) {
      if (diagnostic.place.file == program.name) diagnostic.place.file = candidate.path;
    }
  }
  return {candidate.path, std::move(result.diagnostics), result.blocks, time.count(),
          std::move(result.laws)};
}

std::vector<CheckedProgram> check_all(const std::vector<Candidate>& candidates,
                                      const JobOptions& job) {
  constexpr std::size_t bar_columns = 79;
  const auto machine = machine_file_of(job);
  ProgressLine progress;
  std::vector<CheckedProgram> programs;
  for (const Candidate& candidate : candidates) {
    if (candidates.size() > 1)
      progress.show(progress_bar(programs.size(), candidates.size(), candidate.path, bar_columns));
    programs.push_back(checked(candidate, job, machine.machine));
    progress.clear();
    if (job.json) continue;
    for (const Diagnostic& diagnostic : programs.back().diagnostics) print(diagnostic);
  }
  return programs;
}

int run(const CheckOptions& options) {
  std::vector<Candidate> candidates;
  bool folders = false;
  for (const std::string& name : options.programs) {
    if (!fs::is_directory(name)) {
      candidates.push_back({name, {}});
      continue;
    }
    folders = true;
    const auto found = programs_below(name);
    candidates.insert(candidates.end(), found.begin(), found.end());
  }
  const auto programs = check_all(candidates, options.job);
  int exit_code = 0;
  auto all = nlohmann::ordered_json::array();
  for (const CheckedProgram& program : programs) {
    for (const Diagnostic& diagnostic : program.diagnostics) {
      exit_code = std::max(exit_code, exit_code_of(diagnostic));
      all.push_back(to_json(diagnostic));
    }
  }
  if (options.estimate && options.job.json) {
    write_json(estimate_json(programs));
  } else if (options.estimate) {
    write_data(estimate_table(programs, Terminal(STDOUT_FILENO)));
  } else if (options.job.json) {
    write_json(folders ? summary_json(programs) : all);
  } else if (folders) {
    write_data(summary_table(programs, Terminal(STDOUT_FILENO)));
  } else if (all.empty()) {
    write_data(Terminal(STDOUT_FILENO).coloured("no errors", Colour::green) + "\n");
  }
  return exit_code;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "find errors of programs without running them");
  command->add_option("PROGRAM", options->programs, "part programs, or folders of them")
      ->type_name("FILE")
      ->required();
  command->add_flag("--estimate", options->estimate,
                    "time and figures of each block under a feed law; with --json an object");
  add_job_options(*command, options->job);
  add_steps_option(*command, options->job);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace stanok::client
