// `stanok explain CODE`: what a code of the catalogue means and what to do.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stanok::client {

void add_explain_command(CLI::App& app, int& exit_code);

// The text of a code; "" when the catalogue has no such code. Lower case is understood.
[[nodiscard]] std::string explanation(const std::string& code);

}  // namespace stanok::client
