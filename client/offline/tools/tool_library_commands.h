// `stanok tool import` and `stanok tool export`: tool libraries of other programs and controls to
// stanok's tables file and back. No daemon takes part; `stanok tool load` brings the tables file
// into one.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_tool_library_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
