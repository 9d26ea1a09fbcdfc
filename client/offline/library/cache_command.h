// `stanok cache`: what lies in a cache of results, and room for what is to come.
#pragma once

#include <CLI/CLI.hpp>

namespace stanok::client {

void add_cache_commands(CLI::App& app, int& exit_code);

}  // namespace stanok::client
