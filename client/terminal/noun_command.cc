#include "client/terminal/noun_command.h"

namespace stanok::client {

CLI::App& noun_command(CLI::App& app, const std::string& noun, const std::string& help) {
  const auto existing =
      app.get_subcommands([&](const CLI::App* command) { return command->get_name() == noun; });
  if (!existing.empty()) return *existing.front();
  CLI::App* made = app.add_subcommand(noun, help);
  made->require_subcommand(1);
  return *made;
}

}  // namespace stanok::client
