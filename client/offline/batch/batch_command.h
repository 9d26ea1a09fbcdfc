// `stanok batch`: libraries of programs, in chunks, by this computer or by a cluster under Slurm.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_batch_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
