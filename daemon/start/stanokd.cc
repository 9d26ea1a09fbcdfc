// stanokd: the runtime daemon. Command line and exit codes; everything else is in
// daemon/start/daemon.h.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <map>

#include "base/utf8.h"
#include "daemon/host/daemon_log.h"
#include "daemon/start/daemon.h"
#include "protocol/contract/version.h"

namespace {

using stanok::daemon::DaemonOptions;
using stanok::runtime::DriveChoice;

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

struct CommandLine {
  DaemonOptions options;
  bool check_only = false;
};

void add_options(CLI::App& app, CommandLine& given) {
  static const std::map<std::string, DriveChoice> choices = {{"real", DriveChoice::real},
                                                             {"embedded", DriveChoice::embedded}};
  app.add_option("--machine", given.options.machine_file, "machine file (TOML)")
      ->type_name("FILE")
      ->required();
  app.add_option("--state", given.options.state_directory, "state directory")->type_name("FOLDER");
  app.add_option("--socket", given.options.socket, "socket for operators")->type_name("PATH");
  app.add_option("--lcm", given.options.lcm, "LCM URL, or off")->type_name("URL");
  app.add_option("--program-root", given.options.program_root, "folder of the part programs")
      ->type_name("FOLDER");
  app.add_option("--drives", given.options.drives,
                 "real: drives on the bus; embedded: simulated drives inside the daemon")
      ->transform(CLI::CheckedTransformer(choices).description(""))
      ->type_name("real|embedded");
  app.add_option("--log", given.options.log_directory, "folder for LCM logs")->type_name("FOLDER");
  app.add_option("--panel-user", given.options.panel_user,
                 "user who runs stanok-web, which may do everything and checks its own users")
      ->type_name("USER");
  app.add_flag("--check-config", given.check_only,
               "check the machine file, print its errors and exit");
}

int run(const CommandLine& given) {
  if (given.check_only) {
    const auto file = stanok::config::read_machine_file(given.options.machine_file);
    std::printf("%s: %zu channels, %zu axes, no errors\n", file.machine.name.c_str(),
                file.machine.channels.size(), file.machine.axes.size());
    return 0;
  }
  const stanok::daemon::DaemonLog log;
  return stanok::daemon::run_daemon(given.options);
}

// The exit code; throws what cannot be handled here.
int run(int argc, char** argv) {
  CLI::App app("stanokd: runs a machine");
  app.set_version_flag("--version", std::string(stanok::protocol::version));
  CommandLine given;
  add_options(app, given);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  return run(given);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stanokd: %s\n", stanok::valid_utf8(error.what()).c_str());
    return exit_failed;
  }
}
