// `stanok interpret`: the records of a program after block preparation, one JSON object a line.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_interpret_command(CLI::App& app, int& exit_code);

}  // namespace stanok::client
