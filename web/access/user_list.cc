#include "web/access/user_list.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>

#include "base/system_error.h"
#include "base/utf8.h"
#include "web/access/private_file.h"

namespace stanok::web {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t name_bytes_max = 64;

[[noreturn]] void fail(const fs::path& file, const std::string& text) {
  throw std::runtime_error(file.string() + ": " + text);
}

User user_of(const std::string& line, const fs::path& file, int number) {
  const std::string place = "line " + std::to_string(number) + ": ";
  const auto first = line.find(':');
  const auto second = line.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos)
    fail(file, place + "a line must be NAME:ROLE:HASH, as written by stanok-web user add");
  const std::string role = line.substr(first + 1, second - first - 1);
  const auto known = protocol::role_named(role);
  if (!known) fail(file, place + "unknown role " + role);
  User user{line.substr(0, first), *known, line.substr(second + 1)};
  if (const std::string defect = defect_of_name(user.name); !defect.empty())
    fail(file, place + defect);
  return user;
}

}  // namespace

std::string defect_of_name(std::string_view name) {
  if (name.empty() || name.size() > name_bytes_max)
    return "a name must have 1 to " + std::to_string(name_bytes_max) + " bytes";
  if (!is_utf8(name)) return "a name must be UTF-8";
  const bool has_bad = std::any_of(name.begin(), name.end(), [](char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code < 0x20 || code == 0x7F || letter == ':';
  });
  if (has_bad || name.front() == '#' || name.front() == ' ' || name.back() == ' ')
    return "a name must not contain a colon or control characters, begin with # or a blank, or end "
           "with a blank";
  return "";
}

UserList UserList::from_file(const fs::path& file) {
  UserList list;
  std::error_code error;
  if (fs::status(file, error).type() == fs::file_type::not_found) return list;
  refuse_open_file(file);
  std::ifstream stream(file);
  if (!stream) fail(file, system_error_text(errno));
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    User user = user_of(line, file, number);
    if (list.find(user.name) != nullptr)
      fail(file, "line " + std::to_string(number) + ": " + user.name + " appears twice");
    list.users_.push_back(std::move(user));
  }
  return list;
}

void UserList::write(const fs::path& file) const {
  std::string text = "# Users of stanok-web; stanok-web user add and remove change them.\n";
  for (const User& user : users_) {
    text += user.name + ':' + std::string(protocol::role_name(user.role)) + ':' +
            user.password_hash + '\n';
  }
  write_private_file(file, text);
}

const User* UserList::find(std::string_view name) const {
  const auto found = std::find_if(users_.begin(), users_.end(),
                                  [&](const User& user) { return user.name == name; });
  return found == users_.end() ? nullptr : &*found;
}

void UserList::set(User user) {
  static_cast<void>(remove(user.name));
  users_.push_back(std::move(user));
}

bool UserList::remove(std::string_view name) {
  return std::erase_if(users_, [&](const User& user) { return user.name == name; }) > 0;
}

}  // namespace stanok::web
