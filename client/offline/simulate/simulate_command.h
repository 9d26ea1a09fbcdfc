// `stanok simulate`: the whole runtime on a virtual clock, from the command line.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

// Adds the subcommand; `exit_code` receives the outcome (docs/reference/command-line.md, "Exit
// codes").
void add_simulate_command(CLI::App& app, int& exit_code);

}  // namespace stanok::client
