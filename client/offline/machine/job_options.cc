#include "client/offline/machine/job_options.h"

#include <charconv>

#include "runtime/standard_cycles.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

int integer(const std::string& text, const std::string& option) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw CLI::ValidationError(option, "'" + text + "' is not a whole number");
  }
  return value;
}

}  // namespace

void add_job_options(CLI::App& command, JobOptions& options) {
  command.add_option("--machine", options.machine_file, "machine file (TOML)")
      ->type_name("FILE")
      ->required();
  command.add_option("--channel", options.channel, "channel of PROGRAM")->capture_default_str();
  command.add_option("--scheme", options.schemes, "CH=ID: kinematic scheme active at the start")
      ->type_name("CH=ID");
  command
      .add_option("--program-root", options.program_root,
                  "folder in which programs are searched for")
      ->type_name("FOLDER");
  command.add_flag("--json", options.json, "print JSON");
}

void add_steps_option(CLI::App& command, JobOptions& options) {
  command
      .add_option("--steps", options.steps,
                  "stop a program that does not end after this many million steps")
      ->check(CLI::Range(1, 1'000'000));
}

config::MachineFile machine_file_of(const JobOptions& options) {
  config::MachineFile file = config::read_machine_file(options.machine_file);
  file.machine.program_bounds.blocks = options.limit;
  if (options.steps > 0) {
    file.machine.program_bounds.steps = static_cast<std::uint64_t>(options.steps) * 1'000'000;
  }
  return file;
}

std::pair<int, std::string> channel_assignment(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size()) {
    throw CLI::ValidationError(option, "'" + text + "' is not of the form CH=...");
  }
  return {integer(text.substr(0, equals), option), text.substr(equals + 1)};
}

std::vector<std::pair<int, int>> scheme_choices(const JobOptions& options) {
  std::vector<std::pair<int, int>> choices;
  for (const std::string& text : options.schemes) {
    const auto [channel, id] = channel_assignment(text, "--scheme");
    choices.emplace_back(channel, integer(id, "--scheme"));
  }
  return choices;
}

int scheme_of(const JobOptions& options) {
  for (const auto& [channel, scheme] : scheme_choices(options)) {
    if (channel == options.channel) return scheme;
  }
  return -1;
}

LocatedProgram locate(const std::string& program) {
  const fs::path path(program);
  const fs::path folder = path.parent_path();
  return {path.filename().string(), folder.empty() ? fs::path(".") : folder};
}

std::vector<fs::path> search_roots(const std::vector<LocatedProgram>& programs,
                                   const JobOptions& options) {
  std::vector<fs::path> roots;
  roots.reserve(programs.size() + 1);
  for (const LocatedProgram& program : programs) roots.push_back(program.folder);
  if (!options.program_root.empty()) roots.emplace_back(options.program_root);
  for (const fs::path& folder : runtime::standard_cycle_folders()) roots.push_back(folder);
  return roots;
}

}  // namespace stanok::client
