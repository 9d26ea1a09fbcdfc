// What is wrong with the words of a command line that should name a command.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace stanok::client {

// "there is no command ..." with the nearest one, or "... needs one of ...", and a line end; empty
// where the words name a command.
[[nodiscard]] std::string command_fault(const CLI::App& app, std::span<const std::string> words);

}  // namespace stanok::client
