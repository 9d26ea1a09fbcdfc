// `stanok process`: what a process engineer asks of a cut before it is made.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_process_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
