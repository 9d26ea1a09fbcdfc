// Manual pages, made from the subcommands and options that `stanok` really has.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace stanok::client {

struct ManualPage {
  std::string name;  // "stanok-program", of section 1
  std::string text;  // for man(1): roff with the macros of man(7)
};

// stanok(1), then one page for every subcommand of `app`: stanok-program(1) has all verbs of
// `program`. `man stanok program` finds it.
[[nodiscard]] std::vector<ManualPage> manual_pages(const CLI::App& app);

// Writes all pages as NAME.1 into the folder, which is made; throws
// std::filesystem::filesystem_error and std::runtime_error when that is not possible.
void write_manual_pages(const CLI::App& app, const std::filesystem::path& folder);

}  // namespace stanok::client
