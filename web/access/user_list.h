// UserList: who may enter with a password, and in which role: a file with a line for each.
//
//   # comment
//   anna:operator:$argon2id$v=19$m=65536,t=2,p=1$...
//
// Private (web/access/private_file.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/contract/method_table.h"

namespace stanok::web {

struct User {
  std::string name;
  protocol::Role role = protocol::Role::observer;
  std::string password_hash;

  friend bool operator==(const User&, const User&) = default;
};

class UserList {
 public:
  UserList() = default;
  // A file that is not there has no users. Throws std::runtime_error with file, line and reason.
  [[nodiscard]] static UserList from_file(const std::filesystem::path& file);
  // Throws std::runtime_error; the file is then as it was.
  void write(const std::filesystem::path& file) const;

  [[nodiscard]] const std::vector<User>& users() const { return users_; }
  // nullptr: there is none.
  [[nodiscard]] const User* find(std::string_view name) const;
  // In the place of the one who has that name.
  void set(User user);
  // False: there was none.
  [[nodiscard]] bool remove(std::string_view name);

 private:
  std::vector<User> users_;
};

// Why a name cannot be one; empty: it can.
[[nodiscard]] std::string defect_of_name(std::string_view name);

}  // namespace stanok::web
