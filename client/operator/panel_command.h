// `stanok panel`: asks the stanok-web beside the daemon for a link to its page, prints it, and
// opens it in a browser where there is a screen.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stanok::client {

// `socket` and `exit_code` outlive the application.
void add_panel_command(CLI::App& app, const std::string& socket, int& exit_code);

}  // namespace stanok::client
