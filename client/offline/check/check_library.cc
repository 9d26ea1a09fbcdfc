#include "client/offline/check/check_library.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "client/offline/check/check_record.h"
#include "client/offline/check/check_report.h"
#include "client/offline/check/law_report.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/output.h"
#include "client/terminal/plane_table.h"
#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "protocol/contract/plane_json.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

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
  auto result = jobs::check_program(machine, job.channel, scheme_of(job), program.name, files);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  if (!candidate.folder.empty()) {  // in a folder a name alone may be that of several programs
    for (Diagnostic& diagnostic : result.diagnostics) {
      if (diagnostic.place.file == program.name) diagnostic.place.file = candidate.path;
    }
    for (PlanePosition& plane : result.planes) {
      if (plane.place.file == program.name) plane.place.file = candidate.path;
    }
  }
  return {candidate.path, std::move(result.diagnostics), result.blocks,
          time.count(),   std::move(result.laws),        std::move(result.planes)};
}

// A program whose check ended the process that did it.
CheckedProgram lost_check(const Candidate& candidate, const std::string& death) {
  Diagnostic diagnostic;
  diagnostic.code = "E8006";
  diagnostic.place.file = candidate.path;
  diagnostic.message = "the check of " + candidate.path + " ended its process: " + death;
  diagnostic.help = {"this is a fault of stanok: report it, with the program"};
  return {candidate.path, {diagnostic}, 0, 0.0};
}

// Prints what belongs to all programs; the exit code.
int print_checked(const std::vector<CheckedProgram>& programs, const CheckWanted& wanted,
                  ProgramsNamed named) {
  int exit_code = 0;
  auto all = nlohmann::ordered_json::array();
  PlanePositions planes;
  for (const CheckedProgram& program : programs) {
    for (const Diagnostic& diagnostic : program.diagnostics) {
      exit_code = std::max(exit_code, exit_code_of(diagnostic));
      all.push_back(to_json(diagnostic));
    }
    planes.insert(planes.end(), program.planes.begin(), program.planes.end());
  }
  const bool has_folders = named == ProgramsNamed::by_folders;
  if (wanted.estimate && wanted.job.json) {
    write_json(estimate_json(programs));
  } else if (wanted.estimate) {
    write_data(estimate_table(programs, Terminal(STDOUT_FILENO)));
  } else if (wanted.job.json) {
    write_json(has_folders ? summary_json(programs) : all);
  } else if (has_folders) {
    write_data(summary_table(programs, Terminal(STDOUT_FILENO)));
  } else {
    const Terminal terminal(STDOUT_FILENO);
    if (all.empty()) write_data(terminal.coloured("no errors", Colour::green) + "\n");
    write_data(plane_table(protocol::plane_json(planes), terminal));
  }
  return exit_code;
}

}  // namespace

LibraryWork check_work(const CheckWanted& wanted) {
  const JobOptions& job = wanted.job;
  const auto file = std::make_shared<const config::MachineFile>(machine_file_of(job));
  return {.result =
              [job, file](const Candidate& candidate, runtime::TextBook& book) {
                return check_record(checked(candidate, job, file->machine, book));
              },
          .files =
              [job, file](const Candidate& candidate) {
                return std::make_unique<runtime::ProgramFiles>(
                    files_of(candidate, job, file->machine, nullptr));
              },
          .context = [job, file] { return context_of(*file, asked_of(job)); }};
}

LibraryOutput check_output(const CheckWanted& wanted, ProgramsNamed named) {
  const auto programs = std::make_shared<std::vector<CheckedProgram>>();
  return {.take =
              [=](const Candidate& candidate, const std::string& result, const std::string& death) {
                programs->push_back(death.empty() ? checked_program(result)
                                                  : lost_check(candidate, death));
                if (wanted.job.json) return;
                for (const Diagnostic& diagnostic : programs->back().diagnostics) print(diagnostic);
              },
          .finish = [=] { return print_checked(*programs, wanted, named); }};
}

}  // namespace stanok::client
