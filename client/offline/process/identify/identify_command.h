// `stanok process identify`: the figures of a cut from the log of one.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_identify_command(CLI::App& noun, int& exit_code);

}  // namespace stanok::client
