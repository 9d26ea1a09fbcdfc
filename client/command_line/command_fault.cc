#include "client/command_line/command_fault.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/nearest_name.h"

namespace stanok::client {
namespace {

std::string in_backticks(const std::string& text) {
  return "`" + text + "`";
}

std::vector<std::string> names_of_commands(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

std::string unknown(const std::string& path, const std::string& word,
                    const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view nearest = nearest_name(word, known);
  std::string text = "there is no command " + in_backticks(path + " " + word);
  if (!nearest.empty())
    text += "; did you mean " + in_backticks(path + " " + std::string(nearest)) + "?";
  return text + "\n" + in_backticks(path + " --help") + " lists the commands\n";
}

std::string incomplete(const std::string& path, const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return in_backticks(path) + " needs one of its commands: " + list + "\n" +
         in_backticks(path + " --help") + " describes them\n";
}

}  // namespace

std::string command_fault(const CLI::App& app, std::span<const std::string> words) {
  const CLI::App* at = &app;
  std::string path = "stanok";
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].starts_with('-')) {
      if (words[i] == "--socket") ++i;  // and the path behind it
      continue;
    }
    const auto subcommands = at->get_subcommands(nullptr);
    if (subcommands.empty()) return "";  // what follows are arguments
    const auto named = std::ranges::find_if(
        subcommands, [&](const CLI::App* command) { return command->check_name(words[i]); });
    if (named == subcommands.end()) return unknown(path, words[i], names_of_commands(subcommands));
    path += " " + words[i];
    at = *named;
  }
  const auto subcommands = at->get_subcommands(nullptr);
  return subcommands.empty() ? "" : incomplete(path, names_of_commands(subcommands));
}

}  // namespace stanok::client
