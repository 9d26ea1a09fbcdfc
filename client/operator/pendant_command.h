// `stanok pendant`: a wheel and keys at an input device of Linux move the axes of a channel.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stanok::client {

// `socket` and `exit_code` outlive the application.
void add_pendant_command(CLI::App& app, const std::string& socket, int& exit_code);

}  // namespace stanok::client
