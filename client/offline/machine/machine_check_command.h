// `stanok machine check`: all that can be known of a machine file without its machine.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_machine_check_command(CLI::App& app, int& exit_code);

}  // namespace stanok::client
