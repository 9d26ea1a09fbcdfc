#include "client/offline/check/check_command.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "client/offline/check/check_record.h"
#include "client/offline/check/check_report.h"
#include "client/offline/check/law_report.h"
#include "client/offline/library/library_run.h"
#include "client/offline/machine/job_options.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "config/files/machine_file.h"
#include "runtime/dry_run.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

struct CheckOptions {
  JobOptions job;
  std::vector<std::string> programs;
  LibraryOptions library;
  bool estimate = false;
};

runtime::ProgramFiles files_of(const Candidate& candidate, const JobOptions& job,
                               const channels::MachineConfig& machine, runtime::TextBook* book) {
  std::vector<LocatedProgram> roots{locate(candidate.path)};
  if (!candidate.folder.empty()) roots.push_back({"", candidate.folder});
  return {search_roots(roots, job), runtime::program_format(machine), book};
}

CheckedProgram checked(const Candidate& candidate, const JobOptions& job,
                       const channels::MachineConfig& machine, runtime::TextBook& book) {
  const auto begin = std::chrono::steady_clock::now();
  const LocatedProgram program = locate(candidate.path);
  const runtime::ProgramFiles files = files_of(candidate, job, machine, &book);
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

// A program whose check ended the process that did it.
CheckedProgram lost(const Candidate& candidate, const std::string& death) {
  Diagnostic diagnostic;
  diagnostic.code = "E8006";
  diagnostic.place.file = candidate.path;
  diagnostic.message = "the check of " + candidate.path + " ended its process: " + death;
  diagnostic.help = {"this is a fault of stanok: report it, with the program"};
  return {candidate.path, {diagnostic}, 0, 0.0};
}

// All programs in their order; nothing: interrupted.
std::optional<std::vector<CheckedProgram>> check_all(const Candidates& candidates,
                                                     const CheckOptions& options) {
  const JobOptions& job = options.job;
  const auto file = machine_file_of(job);
  const channels::MachineConfig& machine = file.machine;
  std::vector<CheckedProgram> programs;
  const auto keep = [&](CheckedProgram program) {
    programs.push_back(std::move(program));
    if (job.json) return;
    for (const Diagnostic& diagnostic : programs.back().diagnostics) print(diagnostic);
  };
  const LibraryWork work{
      .result =
          [&](const Candidate& candidate, runtime::TextBook& book) {
            return check_record(checked(candidate, job, machine, book));
          },
      .files =
          [&](const Candidate& candidate) {
            return std::make_unique<runtime::ProgramFiles>(
                files_of(candidate, job, machine, nullptr));
          },
      .take =
          [&](const Candidate& candidate, const std::string& result, const std::string& death) {
            keep(death.empty() ? checked_program(result) : lost(candidate, death));
          },
      .context = options.library.cache.empty() ? "" : context_of(file, asked_of(job))};
  if (!run_library(candidates, options.library, work)) return std::nullopt;
  return programs;
}

int run(const CheckOptions& options) {
  const Candidates candidates = candidates_of(options.programs);
  const auto found = check_all(candidates, options);
  if (!found) return exit_interrupted;
  const std::vector<CheckedProgram>& programs = *found;
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
    write_json(candidates.has_folders ? summary_json(programs) : all);
  } else if (candidates.has_folders) {
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
  command
      ->add_option("--limit", options->job.limit,
                   "follow no program for more than so many blocks (W820)")
      ->check(CLI::PositiveNumber)
      ->type_name("BLOCKS");
  add_library_options(*command, options->library);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace stanok::client
