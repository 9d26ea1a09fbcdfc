// `stanok log info|situations|export|plot`: what a log file holds, as a summary, as situations, as
// CSV, as pictures.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_log_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
