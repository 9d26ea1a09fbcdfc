#include "client/command_line/completion.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "base/assert.h"
#include "base/catalogue.h"
#include "base/enum_names.h"
#include "protocol/contract/method_table.h"

namespace stanok::client {
namespace {

// What an argument of a command is.
enum class Argument { none, file, program, code };

constexpr auto argument_names = enum_names<Argument>({
    {Argument::none, "none"},
    {Argument::file, "file"},
    {Argument::program, "program"},
    {Argument::code, "code"},
});

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

std::string words_of_command(const CLI::App& command, const std::string& path) {
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
  if (path == "completion") {
    for (const std::string& shell : completion_shells()) words += shell + " ";
  }
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
  rows.push_back({path, words_of_command(command, path), argument_of(command, path)});
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

// The program names of the daemon that runs, one a line; nothing without one.
constexpr std::string_view programs =
    R"(stanok program list --json --timeout 1 2>/dev/null | grep -o '"name":"[^"]*"' | cut -d'"' -f4)";

// Words before the one that is completed that are no options nor their values name the command;
// words that are no subcommand are its arguments: they are taken off. Bash and zsh have the same.
constexpr std::string_view search_of_bash_and_zsh =
    R"script(  local route="" offered="" argument=none word value=""
  local valued="<VALUED>" filed="<FILED>"
  for word in <WORDS BEFORE>; do
    if [[ -n $value ]]; then value=""; continue; fi
    case "$word" in
    -*) [[ $valued == *"|$word|"* ]] && value="$word" ;;
    *) route="${route:+$route }$word" ;;
    esac
  done
  while :; do
    case "$route" in
<CASES>    *" "*) route="${route% *}"; continue ;;
    *) route=""; continue ;;
    esac
    break
  done
  if [[ -n $value ]]; then
    offered="" argument=none
    [[ $filed == *"|$value|"* ]] && argument=file
  fi
)script";
constexpr std::string_view case_of_bash_and_zsh =
    R"(    "<PATH>") offered="<OFFERED>" argument=<ARGUMENT> ;;
)";

// What a shell needs: its script, and in it a case for each command. The names in brackets are
// filled in.
struct Shell {
  std::string_view name;
  std::string_view words_before;
  std::string_view one_case;
  std::string_view script;
};

constexpr auto shells = std::to_array<Shell>({
    {"bash", R"("${COMP_WORDS[@]:1:COMP_CWORD-1}")", case_of_bash_and_zsh,
     R"script(_stanok() {
  local current="${COMP_WORDS[COMP_CWORD]}"
<SEARCH>  case "$argument" in
  program) offered="$offered $(<PROGRAMS>)" ;;
  code) offered="$offered <CODES>" current="${current^^}" ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$current")
  if [[ $argument == file ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$current")
  fi
}
complete -o bashdefault -o default -F _stanok stanok
)script"},
    {"zsh", R"("${(@)words[2,CURRENT-1]}")", case_of_bash_and_zsh,
     R"script(#compdef stanok
_stanok() {
  emulate -L zsh
<SEARCH>  case "$argument" in
  program) offered="$offered $(<PROGRAMS>)" ;;
  code) offered="$offered <CODES>" ;;
  esac
  compadd -- ${=offered}
  [[ $argument == file ]] && _files
  return 0
}
if [[ ${zsh_eval_context[-1]} == loadautofunc ]]; then
  _stanok "$@"
else
  compdef _stanok stanok
fi
)script"},
    {"fish", "", R"(      case '<PATH>'
        set offered <OFFERED>
        set argument <ARGUMENT>
        break
)",
     R"script(function __stanok_offers
  set -l valued '<VALUED>'
  set -l filed '<FILED>'
  set -l route
  set -l value
  set -l offered
  set -l argument none
  for word in (commandline -opc)[2..-1]
    if test -n "$value"
      set value
      continue
    end
    if string match -q -- '-*' $word
      string match -q -- "*|$word|*" $valued; and set value $word
    else
      set -a route $word
    end
  end
  while true
    switch (string join ' ' $route)
<CASES>      case '*'
        set -e route[-1]
    end
  end
  if test -n "$value"
    set offered
    set argument none
    string match -q -- "*|$value|*" $filed; and set argument file
  end
  for word in $offered
    echo $word
  end
  switch $argument
    case program
      <PROGRAMS>
    case code
      string split -n ' ' '<CODES>'
    case file
      __fish_complete_path (commandline -ct)
  end
end
complete -c stanok -f -a '(__stanok_offers)'
)script"},
});

using Fillings = std::map<std::string_view, std::string>;

// The text with every <NAME> of `fillings` replaced.
std::string filled(std::string_view text, const Fillings& fillings) {
  std::string done;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find('<'), text.size());
    const std::size_t end = text.find('>', begin);
    done += text.substr(0, begin);
    text.remove_prefix(begin);
    const auto filling = end == std::string_view::npos
                             ? fillings.end()
                             : fillings.find(text.substr(1, end - begin - 1));
    const bool is_named = filling != fillings.end();
    done += is_named ? std::string_view(filling->second) : text.substr(0, 1);
    text.remove_prefix(is_named ? end - begin + 1 : std::min<std::size_t>(text.size(), 1));
  }
  return done;
}

std::string cases(const CLI::App& app, std::string_view one_case) {
  std::vector<Offer> rows;
  append_rows(rows, app, "");
  std::string text;
  for (const Offer& row : rows) {
    text += filled(one_case, {{"PATH", row.path},
                              {"OFFERED", row.words},
                              {"ARGUMENT", std::string(argument_names[row.argument])}});
  }
  return text;
}

}  // namespace

std::vector<std::string> completion_shells() {
  std::vector<std::string> names;
  names.reserve(shells.size());
  for (const Shell& shell : shells) names.emplace_back(shell.name);
  return names;
}

std::string completion_script(const CLI::App& app, std::string_view shell_name) {
  const auto shell = std::ranges::find(shells, shell_name, &Shell::name);
  STANOK_ASSERT(shell != shells.end());
  Fillings fillings{
      {"CASES", cases(app, shell->one_case)}, {"CODES", codes()},
      {"FILED", options_with_file(app)},      {"PROGRAMS", std::string(programs)},
      {"VALUED", options_with_value(app)},    {"WORDS BEFORE", std::string(shell->words_before)}};
  fillings.emplace("SEARCH", filled(search_of_bash_and_zsh, fillings));
  return filled(shell->script, fillings);
}

}  // namespace stanok::client
