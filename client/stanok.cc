// stanok: the one tool of a person. Operator client of a running daemon, and every off-line job.
//
// This file names the commands and turns what can go wrong into exit codes (docs/operating.md,
// "Exit codes"); each command lives in a file of its own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "client/exit_codes.h"
#include "client/offline.h"
#include "client/operator_client.h"
#include "client/operator_commands.h"
#include "client/operator_run.h"
#include "protocol/version.h"

namespace {

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
  stanok::client::add_offline_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : stanok::client::exit_usage;
  }
  return exit_code;
}

int fail(const std::exception& error, int exit_code) {
  std::fprintf(stderr, "stanok: %s\n", error.what());
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
