// `stanok history`: what happened on the machines of a cell, from the database of a gateway.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_history_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
