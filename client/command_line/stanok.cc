// stanok: the one tool of a person. Operator client of a running daemon, and every off-line job.
//
// This file names the commands and turns what can go wrong into exit codes
// (docs/reference/command-line.md, "Exit codes"); each command is in a file of its own.
#include <CLI/CLI.hpp>
#include <exception>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "client/command_line/command_fault.h"
#include "client/command_line/offline.h"
#include "client/operator/operator_client.h"
#include "client/operator/operator_commands.h"
#include "client/operator/operator_run.h"
#include "client/operator/panel_command.h"
#include "client/operator/pendant_command.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "protocol/contract/version.h"

namespace {

// Help and version, or what is wrong with the command line.
int tell(const CLI::App& app, const CLI::ParseError& error, std::span<char*> arguments) {
  std::ostringstream data;
  std::ostringstream message;
  const int code = app.exit(error, data, message);
  stanok::client::write_data(data.str());
  if (code == 0) {
    stanok::client::write_message(message.str());
    return 0;
  }
  const std::vector<std::string> words(arguments.begin() + 1, arguments.end());
  const std::string fault = stanok::client::command_fault(app, words);
  stanok::client::write_message(fault.empty() ? message.str() : fault);
  return stanok::client::exit_usage;
}

int run(int argc, char** argv) {
  CLI::App app("stanok: operates a machine, checks and simulates programs");
  app.set_version_flag("--version", std::string(stanok::protocol::version));
  app.require_subcommand(1);
  std::string socket;
  app.add_option("--socket", socket, "socket of the daemon")->type_name("PATH");
  int exit_code = 0;
  stanok::client::add_operator_commands(app, [&](stanok::client::OperatorCall call) {
    if (call.socket.empty()) call.socket = socket;
    exit_code = stanok::client::run_operator_call(call);
  });
  stanok::client::add_panel_command(app, socket, exit_code);
  stanok::client::add_pendant_command(app, socket, exit_code);
  stanok::client::add_offline_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return tell(app, error, {argv, argv + argc});
  }
  return exit_code;
}

int fail(const std::exception& error, int exit_code) {
  stanok::client::write_message("stanok: " + std::string(error.what()) + "\n");
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const stanok::client::ConnectionError& error) {
    return fail(error, stanok::client::exit_no_connection);
  } catch (const stanok::client::Interrupted& error) {
    return fail(error, stanok::client::exit_interrupted);
  } catch (const std::exception& error) {
    return fail(error, stanok::client::exit_failed);
  }
}
