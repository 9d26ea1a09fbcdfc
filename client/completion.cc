#include "client/completion.h"

#include <vector>

namespace stanok::client {
namespace {

std::string words_of(const CLI::App& command) {
  std::string words;
  for (const CLI::App* subcommand : command.get_subcommands(nullptr)) {
    if (!subcommand->get_group().empty()) words += subcommand->get_name() + " ";
  }
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words += "--" + name + " ";
  }
  if (!words.empty()) words.pop_back();
  return words;
}

// One line of a case statement per command: "program run") words="--channel --wait" ;;
void append_cases(std::string& text, const CLI::App& command, const std::string& path) {
  text += "    \"" + path + "\") words=\"" + words_of(command) + "\" ;;\n";
  for (const CLI::App* subcommand : command.get_subcommands(nullptr)) {
    append_cases(text, *subcommand, (path.empty() ? "" : path + " ") + subcommand->get_name());
  }
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string text =
      "_stanok() {\n"
      "  local current=\"${COMP_WORDS[COMP_CWORD]}\" path=\"\" words=\"\" word\n"
      "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
      "    [[ $word == -* ]] || path=\"${path:+$path }$word\"\n"
      "  done\n"
      "  while :; do\n"
      "    case \"$path\" in\n";
  append_cases(text, app, "");
  // A word that is no subcommand is an argument: take it off and look again.
  text +=
      "    *) path=\"${path% *}\"; continue ;;\n"
      "    esac\n"
      "    break\n"
      "  done\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
      "}\n"
      "complete -o bashdefault -o default -F _stanok stanok\n";
  return text;
}

}  // namespace stanok::client
