// What `stanok` tells of itself: `stanok completion SHELL` prints a completion script, `stanok
// manual FOLDER` writes the manual pages. Both are made from the commands as they are.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_completion_command(CLI::App& app);
void add_manual_command(CLI::App& app);

}  // namespace stanok::client
