#include "client/command_line/command_suggestion.h"

#include <string_view>
#include <vector>

#include "base/nearest_name.h"

namespace stanok::client {

std::string command_suggestion(const CLI::App& app, std::span<const std::string> words) {
  const CLI::App* at = &app;
  std::string path = "stanok";
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].starts_with('-')) {
      if (words[i] == "--socket") ++i;  // and the path behind it
      continue;
    }
    const auto subcommands = at->get_subcommands(nullptr);
    if (subcommands.empty()) return "";  // what follows are arguments
    std::vector<std::string> names;
    const CLI::App* named = nullptr;
    for (const CLI::App* subcommand : subcommands) {
      names.push_back(subcommand->get_name());
      if (subcommand->check_name(words[i])) named = subcommand;
    }
    if (named == nullptr) {
      const std::vector<std::string_view> known(names.begin(), names.end());
      const std::string_view nearest = nearest_name(words[i], known);
      return nearest.empty() ? "" : "did you mean `" + path + " " + std::string(nearest) + "`?\n";
    }
    path += " " + words[i];
    at = named;
  }
  return "";
}

}  // namespace stanok::client
