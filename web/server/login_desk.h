// LoginDesk: names and passwords against the list of users, one hash at a time in a thread of its
// own, places by turns, and slower with every failure of a name from a place.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "web/access/login_delays.h"
#include "web/access/login_turns.h"
#include "web/access/sessions.h"
#include "web/access/user_list.h"

namespace stanok::web {

class LoginDesk {
 public:
  // Users come from a file; none: nobody logs in. Throws std::runtime_error when it cannot be read.
  explicit LoginDesk(std::filesystem::path file);

  [[nodiscard]] bool has_users() const { return !users_.users().empty(); }

  // Busy: that name is tried from there already, or it has to wait behind its last failure.
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
  // A claimant whose turn has not come yet.
  struct Waiting {
    boost::asio::steady_timer bell;
    bool is_called = false;
    bool is_pushed_out = false;
  };
  // False: too many wait.
  [[nodiscard]] boost::asio::awaitable<bool> wait_for_turn(const LoginTurns::Entered& entered);
  void call_next();
  void ring(LoginTurns::Ticket ticket, bool Waiting::* what);
  // The user, when it is the password.
  [[nodiscard]] boost::asio::awaitable<std::optional<Identity>> compare(std::string name,
                                                                        std::string password);

  std::filesystem::path file_;
  std::filesystem::file_time_type read_at_{};
  UserList users_;
  std::string nobody_;  // hash for names that there are not
  LoginDelays delays_;
  LoginTurns turns_;
  std::map<LoginTurns::Ticket, Waiting*> waiting_;
  boost::asio::thread_pool hashing_{1};
};

}  // namespace stanok::web
