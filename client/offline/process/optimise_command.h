// `stanok process optimise`: forces along a turning program, and feeds that keep them at a value.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_optimise_command(CLI::App& noun, int& exit_code);

}  // namespace stanok::client
