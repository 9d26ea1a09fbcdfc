#include "client/command_line/self_commands.h"

#include <memory>
#include <string>

#include "client/command_line/completion.h"
#include "client/command_line/manual_pages.h"
#include "client/terminal/output.h"

namespace stanok::client {

void add_completion_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("completion", "completion script for a shell");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember(completion_shells()));
  command->callback([shell, &app] { write_data(completion_script(app, *shell)); });
}

void add_manual_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("manual", "write the manual pages of stanok");
  const auto folder = std::make_shared<std::string>();
  command->add_option("FOLDER", *folder, "where NAME.1 of every page is written")->required();
  command->callback([folder, &app] { write_manual_pages(app, *folder); });
}

}  // namespace stanok::client
