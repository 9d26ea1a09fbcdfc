// `stanok check`: all that can be known of programs before a run.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_check_command(CLI::App& app, int& exit_code);

}  // namespace stanok::client
