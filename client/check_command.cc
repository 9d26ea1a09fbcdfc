#include "client/check_command.h"

#include <algorithm>
#include <cstdio>

#include "client/diagnostic_output.h"
#include "client/job_options.h"
#include "config/machine_file.h"
#include "runtime/dry_run.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

struct CheckOptions {
  JobOptions job;
  std::vector<std::string> programs;
};

int run(const CheckOptions& options) {
  const auto machine = config::read_machine_file(options.job.machine_file);
  int scheme = -1;
  for (const auto& [channel, id] : scheme_choices(options.job)) {
    if (channel == options.job.channel) scheme = id;
  }
  Diagnostics all;
  for (const std::string& name : options.programs) {
    const LocatedProgram program = locate(name);
    const runtime::ProgramFiles files(search_roots({program}, options.job));
    const Diagnostics found =
        runtime::check_program(machine.machine, options.job.channel, scheme, program.name, files);
    all.insert(all.end(), found.begin(), found.end());
  }
  int exit_code = 0;
  auto json = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : all) {
    exit_code = std::max(exit_code, exit_code_of(diagnostic));
    json.push_back(to_json(diagnostic));
    if (!options.job.json) print(diagnostic);
  }
  if (options.job.json) std::printf("%s\n", json.dump().c_str());
  if (!options.job.json && all.empty()) std::printf("no errors\n");
  return exit_code;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "find errors of programs without running them");
  command->add_option("PROGRAM", options->programs, "part programs")->required();
  add_job_options(*command, options->job);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace stanok::client
