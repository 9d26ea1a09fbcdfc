// `stanok log export`: setpoints of a log, or what it tells of the cutting process, as tables.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_export_command(CLI::App& noun, int& exit_code);

}  // namespace stanok::client
