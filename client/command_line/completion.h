// Shell completion, made from the subcommands and options that `stanok` really has.
//
// A script offers the subcommands and options that fit, names of files where a file is wanted,
// programs that the daemon has (stanok program list) and codes of the catalogue.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::client {

// "bash", "zsh", "fish".
[[nodiscard]] std::vector<std::string> completion_shells();

// For one of them: `eval "$(stanok completion bash)"`; `eval "$(stanok completion zsh)"` behind
// compinit, or as the file _stanok of fpath; `stanok completion fish | source`.
[[nodiscard]] std::string completion_script(const CLI::App& app, std::string_view shell);

}  // namespace stanok::client
