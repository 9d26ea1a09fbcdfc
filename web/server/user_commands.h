// `stanok-web user add|remove|list`: the users of the page.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

namespace stanok::web {

// `users` is the file that --users names, `exit_code` what the command ends with; both outlive the
// application. A command that was called sets `exit_code`.
void add_user_commands(CLI::App& app, const std::filesystem::path& users, int& exit_code);

}  // namespace stanok::web
