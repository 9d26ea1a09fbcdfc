// What a word of the command line was probably meant to be, when no command has that name.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace stanok::client {

// "did you mean `stanok check`?" and a line end; empty when every command is known or none is near.
[[nodiscard]] std::string command_suggestion(const CLI::App& app,
                                             std::span<const std::string> words);

}  // namespace stanok::client
