#include "client/command_line/manual_pages.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string_view>

#include "base/place.h"
#include "client/command_line/roff.h"
#include "protocol/contract/version.h"

namespace stanok::client {
namespace {

struct Meaning {
  std::string_view what;
  std::string_view meaning;
};

constexpr auto exit_codes = std::to_array<Meaning>({
    {"0", "ok"},
    {"1", "refused or failed; also an error in a machine, process or log file"},
    {"2", "wrong usage"},
    {"3", "no connection to the daemon, or it was lost"},
    {"4", "time limit (--timeout or --until) reached"},
    {"5", "not permitted for this role"},
    {"6", "error in a program: codes E and U"},
    {"7", "fault of the machine: codes A"},
    {"8", "log verify: identical up to a cycle after which records were lost (W720)"},
    {"9", "log verify: identical, but the recording was cut: its log ends without a trailer"},
    {"130", "interrupted"},
});

constexpr auto environment = std::to_array<Meaning>({
    {"STANOK_SOCKET", "socket of the daemon, if --socket is not given"},
    {"XDG_RUNTIME_DIR", "otherwise, its folder stanok is searched for sockets of daemons"},
    {"XDG_STATE_HOME",
     "the folder of each machine in its folder stanok is searched too; default ~/.local/state"},
    {"NO_COLOR", "if set: no colors"},
});

constexpr std::string_view introduction =
    "Operates a machine that stanokd(8) runs, and does everything that needs no machine: finds the "
    "errors of programs, runs them on a virtual clock, reads logs, designs grinding cycles.\n";

char upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// A command of the command line with all its words: "stanok program run".
struct Command {
  std::string path;
  const CLI::App* app;
};

std::vector<const CLI::App*> shown_subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

void append_commands(std::vector<Command>& commands, const CLI::App& app, const std::string& path) {
  const auto subcommands = shown_subcommands(app);
  if (subcommands.empty()) commands.push_back({path, &app});
  for (const CLI::App* subcommand : subcommands)
    append_commands(commands, *subcommand, path + " " + subcommand->get_name());
}

std::vector<const CLI::Option*> shown_options(const CLI::App& app) {
  return app.get_options([&](const CLI::Option* option) {
    return !option->get_group().empty() && option != app.get_help_ptr() &&
           option != app.get_help_all_ptr();
  });
}

// "FLOAT:NONNEGATIVE" is a FLOAT.
std::string placeholder(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

bool is_repeated(const CLI::Option& option) {
  return option.get_items_expected_max() > 1;
}

// As the reader types it: --channel N, or PROGRAM.
std::string spelled(const CLI::Option& option) {
  const std::string more = is_repeated(option) ? " ..." : "";
  if (option.get_positional()) return roff::italic(option.get_name(true)) + more;
  std::string text;
  for (const std::string& name : option.get_snames()) text += roff::bold("-" + name) + ", ";
  for (const std::string& name : option.get_lnames()) text += roff::bold("--" + name) + ", ";
  text.resize(text.size() - 2);
  const std::string argument = placeholder(option);
  return argument.empty() ? text : text + " " + roff::italic(argument) + more;
}

std::string description(const CLI::Option& option) {
  const std::string& standard = option.get_default_str();
  const bool has_default = !standard.empty() && standard != "\"\"";
  return option.get_description() + (has_default ? " (default " + standard + ")" : "");
}

std::string described(const CLI::Option& option) {
  return roff::described(spelled(option), description(option));
}

bool are_same(const CLI::Option& one, const CLI::Option& other) {
  return spelled(one) == spelled(other) && description(one) == description(other);
}

bool is_among(std::span<const CLI::Option* const> options, const CLI::Option& option) {
  return std::any_of(options.begin(), options.end(),
                     [&](const CLI::Option* one) { return are_same(*one, option); });
}

// The options that at least so many commands of a page have, each once.
std::vector<const CLI::Option*> options_of(std::span<const Command> commands, std::size_t least) {
  std::vector<const CLI::Option*> options;
  for (const Command& command : commands) {
    for (const CLI::Option* option : shown_options(*command.app)) {
      const auto count = std::count_if(commands.begin(), commands.end(), [&](const Command& one) {
        return is_among(shown_options(*one.app), *option);
      });
      if (!option->get_positional() && checked_size(count) >= least && !is_among(options, *option))
        options.push_back(option);
    }
  }
  return options;
}

std::string options_but(const CLI::App& app, std::span<const CLI::Option* const> left_out) {
  std::string text;
  for (const CLI::Option* option : shown_options(app))
    if (!is_among(left_out, *option)) text += described(*option);
  return text;
}

// "stanok program run [OPTION ...] [--wait] PROGRAM": options first, in brackets when they may be
// left out; those in `understood` are not named.
std::string synopsis(const Command& command, std::span<const CLI::Option* const> understood) {
  std::string line = roff::bold(command.path) + (understood.empty() ? "" : " [OPTION ...]");
  for (const bool positional : {false, true}) {
    for (const CLI::Option* option : shown_options(*command.app)) {
      if (option->get_positional() != positional || is_among(understood, *option)) continue;
      line += option->get_required() ? " " + spelled(*option) : " [" + spelled(*option) + "]";
    }
  }
  return line + "\n";
}

// "Load a program and start it." of "load a program and start it".
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = upper_case(text[0]);
  return roff::escaped(text) + (text.ends_with('.') ? "\n" : ".\n");
}

// What stands before the first colon or semicolon.
std::string short_form(const std::string& text) {
  return text.substr(0, text.find_first_of(":;"));
}

std::string heading(const std::string& name, const std::string& one_line) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), upper_case);
  return ".TH " + title + " 1 \"\" \"stanok " + std::string(protocol::version) + "\" \"stanok\"\n" +
         roff::section("NAME") + roff::escaped(name) + " \\- " + roff::escaped(one_line) +
         "\n.nh\n.ad l\n";  // commands are not hyphenated
}

std::string table(std::string_view title, std::span<const Meaning> rows) {
  std::string text = roff::section(title);
  for (const Meaning& row : rows) text += roff::described(roff::bold(row.what), row.meaning);
  return text;
}

std::string see_also(const std::vector<std::string>& pages) {
  std::string text = roff::section("SEE ALSO");
  for (const std::string& page : pages)
    text += roff::bold(page.substr(0, page.find('('))) + page.substr(page.find('(')) + ",\n";
  return text + "the documents in " + roff::italic("/usr/share/doc/stanok") + "\n";
}

// One command: its page has no list of commands.
std::string text_of_one(const Command& command) {
  const std::string options = options_but(*command.app, {});
  return roff::section("SYNOPSIS") + synopsis(command, {}) + roff::section("DESCRIPTION") +
         sentence(command.app->get_description()) +
         (options.empty() ? "" : roff::section("OPTIONS") + options);
}

// Several: what more than one of them has is described once, what all have is not named in each.
std::string text_of_several(std::span<const Command> commands) {
  const auto of_all = options_of(commands, commands.size());
  const auto shared = options_of(commands, 2);
  std::string lines;
  std::string list;
  for (const Command& command : commands) {
    lines += (lines.empty() ? "" : ".PP\n") + synopsis(command, of_all);
    list += ".SS " + roff::escaped(command.path) + "\n" + sentence(command.app->get_description()) +
            options_but(*command.app, shared);
  }
  std::string text = roff::section("SYNOPSIS") + lines + roff::section("COMMANDS") + list;
  if (!shared.empty()) text += roff::section("OPTIONS");
  for (const CLI::Option* option : shared) text += described(*option);
  return text;
}

ManualPage page_of(const CLI::App& subcommand) {
  const std::string name = "stanok-" + subcommand.get_name();
  std::vector<Command> commands;
  append_commands(commands, subcommand, "stanok " + subcommand.get_name());
  const std::string& help = subcommand.get_description();
  const std::string text = commands.size() == 1
                               ? heading(name, short_form(help)) + text_of_one(commands.front())
                               : heading(name, help) + text_of_several(commands);
  return {name, text + see_also({"stanok(1)", "stanokd(8)"})};
}

std::string main_page(const CLI::App& app) {
  std::string text = heading("stanok", "operate a machine, check and simulate programs") +
                     roff::section("SYNOPSIS") + roff::bold("stanok") + " [" +
                     roff::bold("--socket") + " " + roff::italic("SOCKET") + "] " +
                     roff::italic("COMMAND") + " ...\n" + roff::section("DESCRIPTION") +
                     roff::escaped(introduction) + roff::section("COMMANDS");
  for (const CLI::App* command : shown_subcommands(app)) {
    text += roff::described(roff::bold("stanok-" + command->get_name()) + "(1)",
                            command->get_description());
  }
  text += roff::section("OPTIONS") +
          roff::described(roff::bold("--help"), "what a command and its verbs want") +
          options_but(app, {});
  return text + table("EXIT STATUS", exit_codes) + table("ENVIRONMENT", environment) +
         see_also({"stanokd(8)", "stanok-drives(1)"});
}

}  // namespace

std::vector<ManualPage> manual_pages(const CLI::App& app) {
  std::vector<ManualPage> pages = {{"stanok", main_page(app)}};
  for (const CLI::App* command : shown_subcommands(app)) pages.push_back(page_of(*command));
  return pages;
}

void write_manual_pages(const CLI::App& app, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const ManualPage& page : manual_pages(app)) {
    const auto path = folder / (page.name + ".1");
    std::ofstream file(path, std::ios::binary);
    file << page.text << std::flush;
    if (!file) throw std::runtime_error("cannot write " + path.string());
  }
}

}  // namespace stanok::client
