// Subcommands of `stanok` by noun: operator methods and off-line jobs share nouns (`machine status`
// asks a daemon, `machine check` reads a file).
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stanok::client {

// The subcommand of that name, made on first use; one verb must follow it.
[[nodiscard]] CLI::App& noun_command(CLI::App& app, const std::string& noun,
                                     const std::string& help);

}  // namespace stanok::client
