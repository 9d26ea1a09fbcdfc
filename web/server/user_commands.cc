#include "web/server/user_commands.h"

#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "protocol/contract/method_table.h"
#include "web/access/password.h"
#include "web/access/user_list.h"
#include "web/server/web_options.h"

namespace stanok::web {
namespace {

// What is typed is not shown as long as this lives.
class HiddenInput {
 public:
  HiddenInput() {
    if (::tcgetattr(STDIN_FILENO, &before_) != 0) return;
    termios hidden = before_;
    hidden.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    is_hidden_ = ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden) == 0;
  }
  ~HiddenInput() {
    if (is_hidden_) ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
  }
  HiddenInput(const HiddenInput&) = delete;
  HiddenInput& operator=(const HiddenInput&) = delete;

 private:
  termios before_{};
  bool is_hidden_ = false;
};

std::string line_of_input() {
  std::string line;
  std::getline(std::cin, line);
  return line;
}

std::string typed(const char* question) {
  std::fputs(question, stderr);
  const HiddenInput hidden;
  std::string line = line_of_input();
  std::fputs("\n", stderr);
  return line;
}

// Asked for at a terminal, twice; else the first line of the input.
std::string new_password() {
  const bool is_terminal = ::isatty(STDIN_FILENO) == 1;
  const std::string password = is_terminal ? typed("password: ") : line_of_input();
  if (is_terminal && typed("again: ") != password)
    throw std::runtime_error("the two passwords differ; give the command again");
  if (password.size() < password_bytes_min || password.size() > password_bytes_max)
    throw std::runtime_error("a password must have " + std::to_string(password_bytes_min) + " to " +
                             std::to_string(password_bytes_max) + " bytes");
  return password;
}

void require_file(const std::filesystem::path& users) {
  if (users.empty()) throw UsageError("name the file of the users with --users FILE");
}

void add_user(const std::string& name, const std::string& role, const std::filesystem::path& file) {
  require_file(file);
  if (const std::string defect = defect_of_name(name); !defect.empty()) throw UsageError(defect);
  UserList list = UserList::from_file(file);
  const bool is_new = list.find(name) == nullptr;
  list.set({name, protocol::role_named(role).value_or(protocol::Role::observer),
            hash_of_password(new_password())});
  list.write(file);
  std::printf("%s: %s %s\n", name.c_str(), role.c_str(), is_new ? "added" : "changed");
}

void remove_user(const std::string& name, const std::filesystem::path& file) {
  require_file(file);
  UserList list = UserList::from_file(file);
  if (!list.remove(name)) throw std::runtime_error("there is no user " + name);
  list.write(file);
  std::printf("%s: removed\n", name.c_str());
}

void list_users(const std::filesystem::path& file) {
  require_file(file);
  const UserList list = UserList::from_file(file);
  for (const User& user : list.users()) {
    std::printf("%-24s %s\n", user.name.c_str(),
                std::string(protocol::role_name(user.role)).c_str());
  }
}

void add_file_option(CLI::App& command, std::string& file) {
  command.add_option("--users", file, "file of the users")->type_name("FILE");
}

}  // namespace

void add_user_commands(CLI::App& app, const std::filesystem::path& users, int& exit_code) {
  struct Given {
    std::string name;
    std::string role;
    std::string file;
    [[nodiscard]] std::filesystem::path users_or(const std::filesystem::path& usual) const {
      return file.empty() ? usual : std::filesystem::path(file);
    }
  };
  const auto given = std::make_shared<Given>();
  CLI::App* user = app.add_subcommand("user", "manage the users of the page");
  user->require_subcommand(1);

  CLI::App* add =
      user->add_subcommand("add",
                           "add a user, or change role and password; asks for the password on a "
                           "terminal, otherwise reads it from a line of standard input");
  add->add_option("NAME", given->name, "name of the user")->required();
  add->add_option("--role", given->role, "role of the user; each role includes the ones before it")
      ->required()
      ->check(CLI::IsMember({"observer", "operator", "programmer", "integrator"}));
  add_file_option(*add, given->file);
  add->callback([given, &users, &exit_code] {
    add_user(given->name, given->role, given->users_or(users));
    exit_code = 0;
  });

  CLI::App* remove = user->add_subcommand(
      "remove", "remove a user; a user who is signed in loses the page immediately");
  remove->add_option("NAME", given->name, "name of the user")->required();
  add_file_option(*remove, given->file);
  remove->callback([given, &users, &exit_code] {
    remove_user(given->name, given->users_or(users));
    exit_code = 0;
  });

  CLI::App* list = user->add_subcommand("list", "list the users and their roles");
  add_file_option(*list, given->file);
  list->callback([given, &users, &exit_code] {
    list_users(given->users_or(users));
    exit_code = 0;
  });
}

}  // namespace stanok::web
