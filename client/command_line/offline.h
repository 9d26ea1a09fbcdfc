// The commands of `stanok` that need no daemon, no privileges and no network.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

// Adds them all; `exit_code` receives the outcome of the one that was called.
void add_offline_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
