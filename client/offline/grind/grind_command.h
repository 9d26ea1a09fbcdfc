// `stanok grind design|verify|program|study`: plunge grinding cycles from the sheet of a process to
// a control file, a part program and a picture (docs/programmer/grinding.md).
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_grind_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
