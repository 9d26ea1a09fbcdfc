#include "client/command_line/completion.h"

#include <algorithm>
#include <set>
#include <vector>

#include "base/catalogue.h"
#include "protocol/method_table.h"

namespace stanok::client {
namespace {

// What an argument of a command is.
enum class Argument { none, file, program, code };

const char* word_for(Argument argument) {
  switch (argument) {
    case Argument::none:
      return "none";
    case Argument::file:
      return "file";
    case Argument::program:
      return "program";
    case Argument::code:
      return "code";
  }
  return "";
}

// A command by its words: "program run".
struct Offer {
  std::string path;
  std::string words;  // subcommands, options, values to choose from
  Argument argument = Argument::none;
};

bool is_file(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type == "FILE" || type == "PATH" || type == "FOLDER" || type == "CH=FILE";
}

const protocol::Method* method_of(std::string path) {
  std::replace(path.begin(), path.end(), ' ', '.');
  return protocol::find_method(path);
}

std::string words_of(const CLI::App& command, const std::string& path) {
  std::string words;
  for (const CLI::App* subcommand : command.get_subcommands(nullptr)) {
    if (!subcommand->get_group().empty()) words += subcommand->get_name() + " ";
  }
  if (const protocol::Method* method = method_of(path)) {
    for (const protocol::Parameter& parameter : method->parameters) {
      if (parameter.spelling != protocol::Spelling::positional) continue;
      for (const std::string_view choice : parameter.choices) words += std::string(choice) + " ";
    }
  }
  if (path == "completion") words += "bash zsh fish ";
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words += "--" + name + " ";
  }
  if (!words.empty()) words.pop_back();
  return words;
}

Argument argument_of(const CLI::App& command, const std::string& path) {
  if (path == "explain") return Argument::code;
  const bool is_operated = method_of(path) != nullptr;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    if (is_operated && option->get_name(true) == "PROGRAM") return Argument::program;
    if (is_file(*option)) return Argument::file;
  }
  return Argument::none;
}

void append_rows(std::vector<Offer>& rows, const CLI::App& command, const std::string& path) {
  rows.push_back({path, words_of(command, path), argument_of(command, path)});
  for (const CLI::App* subcommand : command.get_subcommands(nullptr)) {
    if (subcommand->get_group().empty()) continue;
    append_rows(rows, *subcommand, (path.empty() ? "" : path + " ") + subcommand->get_name());
  }
}

// The options of all commands that fit, once each: "|--machine|--socket|".
template <class Fits>
std::string options_that(const CLI::App& app, Fits fits) {
  std::set<std::string> names;
  const std::function<void(const CLI::App&)> visit = [&](const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_lnames()) {
        if (fits(*option)) names.insert("--" + name);
      }
    }
    for (const CLI::App* subcommand : command.get_subcommands(nullptr)) visit(*subcommand);
  };
  visit(app);
  std::string list = "|";
  for (const std::string& name : names) list += name + "|";
  return list;
}

std::string options_with_value(const CLI::App& app) {
  return options_that(app, [](const CLI::Option& o) { return o.get_items_expected_max() > 0; });
}

std::string options_with_file(const CLI::App& app) {
  return options_that(app, [](const CLI::Option& option) { return is_file(option); });
}

std::string codes() {
  std::string list;
  for (const CatalogueRow& row : catalogue()) list += std::string(row.code) + " ";
  return list;
}

// The program names of the daemon at hand, one a line; nothing without one.
constexpr std::string_view programs =
    "stanok program list --json --timeout 1 2>/dev/null | grep -o '\"name\":\"[^\"]*\"' | "
    "cut -d'\"' -f4";

// The cases of bash and zsh are the same.
std::string cases(const CLI::App& app) {
  std::vector<Offer> rows;
  append_rows(rows, app, "");
  std::string text;
  for (const Offer& row : rows) {
    text += "    \"" + row.path + "\") offered=\"" + row.words +
            "\" argument=" + word_for(row.argument) + " ;;\n";
  }
  return text;
}

// Words before the one at hand that are no options nor their values name the command; words that
// are no subcommand are its arguments: they are taken off.
std::string search(const CLI::App& app, std::string_view words_before) {
  return "  local route=\"\" offered=\"\" argument=none word value=\"\"\n"
         "  local valued=\"" +
         options_with_value(app) + "\" filed=\"" + options_with_file(app) +
         "\"\n"
         "  for word in " +
         std::string(words_before) +
         "; do\n"
         "    if [[ -n $value ]]; then value=\"\"; continue; fi\n"
         "    case \"$word\" in\n"
         "    -*) [[ $valued == *\"|$word|\"* ]] && value=\"$word\" ;;\n"
         "    *) route=\"${route:+$route }$word\" ;;\n"
         "    esac\n"
         "  done\n"
         "  while :; do\n"
         "    case \"$route\" in\n" +
         cases(app) +
         "    *\" \"*) route=\"${route% *}\"; continue ;;\n"
         "    *) route=\"\"; continue ;;\n"
         "    esac\n"
         "    break\n"
         "  done\n"
         "  if [[ -n $value ]]; then\n"
         "    offered=\"\" argument=none\n"
         "    [[ $filed == *\"|$value|\"* ]] && argument=file\n"
         "  fi\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  return "_stanok() {\n"
         "  local current=\"${COMP_WORDS[COMP_CWORD]}\"\n" +
         search(app, "\"${COMP_WORDS[@]:1:COMP_CWORD-1}\"") +
         "  case \"$argument\" in\n"
         "  program) offered=\"$offered $(" +
         std::string(programs) +
         ")\" ;;\n"
         "  code) offered=\"$offered " +
         codes() +
         "\" current=\"${current^^}\" ;;\n"
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$offered\" -- \"$current\")\n"
         "  if [[ $argument == file ]]; then\n"
         "    compopt -o filenames 2>/dev/null\n"
         "    mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -o bashdefault -o default -F _stanok stanok\n";
}

std::string zsh_completion(const CLI::App& app) {
  return "#compdef stanok\n"
         "_stanok() {\n"
         "  emulate -L zsh\n" +
         search(app, "\"${(@)words[2,CURRENT-1]}\"") +
         "  case \"$argument\" in\n"
         "  program) offered=\"$offered $(" +
         std::string(programs) +
         ")\" ;;\n"
         "  code) offered=\"$offered " +
         codes() +
         "\" ;;\n"
         "  esac\n"
         "  compadd -- ${=offered}\n"
         "  [[ $argument == file ]] && _files\n"
         "  return 0\n"
         "}\n"
         "if [[ ${zsh_eval_context[-1]} == loadautofunc ]]; then\n"
         "  _stanok \"$@\"\n"
         "else\n"
         "  compdef _stanok stanok\n"
         "fi\n";
}

std::string fish_completion(const CLI::App& app) {
  std::vector<Offer> rows;
  append_rows(rows, app, "");
  std::string table;
  for (const Offer& row : rows) {
    table += "      case '" + row.path + "'\n        set offered " + row.words +
             "\n        set argument " + word_for(row.argument) + "\n        break\n";
  }
  return "function __stanok_offers\n"
         "  set -l valued '" +
         options_with_value(app) + "'\n  set -l filed '" + options_with_file(app) +
         "'\n"
         "  set -l route\n  set -l value\n  set -l offered\n  set -l argument none\n"
         "  for word in (commandline -opc)[2..-1]\n"
         "    if test -n \"$value\"\n      set value\n      continue\n    end\n"
         "    if string match -q -- '-*' $word\n"
         "      string match -q -- \"*|$word|*\" $valued; and set value $word\n"
         "    else\n      set -a route $word\n    end\n"
         "  end\n"
         "  while true\n"
         "    switch (string join ' ' $route)\n" +
         table +
         "      case '*'\n        set -e route[-1]\n"
         "    end\n"
         "  end\n"
         "  if test -n \"$value\"\n"
         "    set offered\n    set argument none\n"
         "    string match -q -- \"*|$value|*\" $filed; and set argument file\n"
         "  end\n"
         "  for word in $offered\n    echo $word\n  end\n"
         "  switch $argument\n"
         "    case program\n      " +
         std::string(programs) +
         "\n"
         "    case code\n      string split -n ' ' '" +
         codes() +
         "'\n"
         "    case file\n      __fish_complete_path (commandline -ct)\n"
         "  end\n"
         "end\n"
         "complete -c stanok -f -a '(__stanok_offers)'\n";
}

}  // namespace stanok::client
