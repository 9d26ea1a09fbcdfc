// LoginDesk: names and passwords against the list of users, one hash at a time in a thread of its
// own, and slower with every failure.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/thread_pool.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "web/access/login_delays.h"
#include "web/access/sessions.h"
#include "web/access/user_list.h"

namespace stanok::web {

class LoginDesk {
 public:
  // Users come from a file; none: nobody logs in. Throws std::runtime_error when it cannot be read.
  explicit LoginDesk(std::filesystem::path file);

  [[nodiscard]] bool has_users() const { return !users_.users().empty(); }

  enum class Refusal { wrong, busy };
  struct Outcome {
    std::optional<Identity> identity;
    Refusal refusal = Refusal::wrong;
  };
  // A wrong password is answered late.
  [[nodiscard]] boost::asio::awaitable<Outcome> log_in(std::string name, std::string password,
                                                       boost::asio::ip::address from);

  // Reads the file again when it has changed. True: it has, and sessions are to be looked at.
  [[nodiscard]] bool look_at_file();
  // Whether who came so would still be let in.
  [[nodiscard]] bool knows(const Identity& identity) const;

 private:
  [[nodiscard]] boost::asio::awaitable<Outcome> judge(const std::string& name,
                                                      const std::string& password,
                                                      const std::string& place);

  std::filesystem::path file_;
  std::filesystem::file_time_type read_at_{};
  UserList users_;
  std::string nobody_;  // hash for names that there are not
  LoginDelays delays_;
  boost::asio::thread_pool hashing_{1};
};

}  // namespace stanok::web
