#include "client/check_command.h"

#include <algorithm>
#include <cstdio>

#include "client/diagnostic_output.h"
#include "client/job_options.h"
#include "client/noun_command.h"
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

// A machine file that can be read is summed up; ConfigError shows every fault of one that cannot.
int check_machine(const std::string& path, bool as_json) {
  const auto file = config::read_machine_file(path);
  if (as_json) {
    nlohmann::ordered_json json;
    json["ok"] = true;
    json["machine"] = file.machine.name;
    json["axes"] = file.machine.axes.size();
    json["channels"] = file.machine.channels.size();
    std::printf("%s\n", json.dump().c_str());
    return 0;
  }
  std::printf("%s: %zu axes, %zu channels, cycle %d us: no errors\n", file.machine.name.c_str(),
              file.machine.axes.size(), file.machine.channels.size(), file.machine.cycle_us);
  return 0;
}

}  // namespace

void add_machine_check_command(CLI::App& app, int& exit_code) {
  struct Options {
    std::string path;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = noun_command(app, "machine", "the machine as a whole")
                          .add_subcommand("check", "find errors of a machine file");
  command->add_option("MACHINE", options->path, "machine file (TOML)")->required();
  command->add_flag("--json", options->json, "print JSON");
  command->callback(
      [options, &exit_code] { exit_code = check_machine(options->path, options->json); });
}

void add_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "find errors of programs without running them");
  command->add_option("PROGRAM", options->programs, "part programs")->required();
  add_job_options(*command, options->job);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace stanok::client
