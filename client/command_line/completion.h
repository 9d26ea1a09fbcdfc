// Shell completion, made from the subcommands and options that `stanok` really has.
//
// A script offers the subcommands and options that fit, names of files where a file is wanted,
// programs that the daemon has (stanok program list) and codes of the catalogue.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stanok::client {

// For bash: `eval "$(stanok completion bash)"`.
[[nodiscard]] std::string bash_completion(const CLI::App& app);
// For zsh: `eval "$(stanok completion zsh)"` behind compinit, or as the file _stanok of fpath.
[[nodiscard]] std::string zsh_completion(const CLI::App& app);
// For fish: `stanok completion fish | source`.
[[nodiscard]] std::string fish_completion(const CLI::App& app);

}  // namespace stanok::client
