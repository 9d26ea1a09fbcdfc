// `stanok workpiece follow SOURCE`: the virtual workpiece beside a machine, from its log or from
// the bus, in a process of its own.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_workpiece_follow_command(CLI::App& app, int& exit_code);

}  // namespace stanok::client
