// Shell completion, made from the subcommands and options that `stanok` really has.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stanok::client {

// A script for bash: `eval "$(stanok completion bash)"`. File names are completed where no
// subcommand or option fits.
[[nodiscard]] std::string bash_completion(const CLI::App& app);

}  // namespace stanok::client
