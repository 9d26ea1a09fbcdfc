#include "client/offline/machine/machine_check_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"
#include "client/terminal/terminal.h"
#include "config/files/machine_file.h"
#include "config/files/machine_remarks.h"

namespace stanok::client {
namespace {

struct MachineCheckOptions {
  std::string path;
  bool json = false;
};

// A machine file that can be read is summed up; ConfigError shows every fault of one that cannot.
int check_machine(const MachineCheckOptions& options) {
  const auto file = config::read_machine_file(options.path);
  const std::vector<std::string> remarks = config::remarks_on(file);
  if (options.json) {
    nlohmann::ordered_json json;
    json["ok"] = true;
    json["machine"] = file.machine.name;
    json["axes"] = file.machine.axes.size();
    json["channels"] = file.machine.channels.size();
    json["warnings"] = remarks;
    write_json(json);
    return 0;
  }
  write_data(fmt::format("{}: {} axes, {} channels, cycle {} us: {}\n", file.machine.name,
                         file.machine.axes.size(), file.machine.channels.size(),
                         file.machine.cycle_us,
                         Terminal(STDOUT_FILENO).coloured("no errors", Colour::green)));
  for (const std::string& remark : remarks)
    write_message(fmt::format("{}: warning: {}\n", options.path, remark));
  return 0;
}

}  // namespace

void add_machine_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<MachineCheckOptions>();
  CLI::App* command = noun_command(app, "machine", "the machine as a whole")
                          .add_subcommand("check", "find errors in a machine file");
  command->add_option("MACHINE", options->path, "machine file (TOML)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = check_machine(*options); });
}

}  // namespace stanok::client
