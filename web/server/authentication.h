// Authentication: lets users in by a one-time link or a password, and knows them by their cookie.
//
// One thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "web/access/one_time_links.h"
#include "web/access/sessions.h"
#include "web/server/answer.h"
#include "web/server/login_desk.h"

namespace stanok::web {

class Authentication {
 public:
  using OnEnd = std::function<void(const std::vector<std::uint64_t>& sessions)>;

  // `on_end` is told the sessions that have ended. Throws std::runtime_error when the users cannot
  // be read.
  Authentication(Scheme scheme, std::filesystem::path users, OnEnd on_end);

  [[nodiscard]] bool has_users() const { return logins_.has_users(); }

  // Cookies are those of a host, not of a port: servers beside each other need different names.
  void set_port(unsigned short port);

  [[nodiscard]] std::string issue_link();
  [[nodiscard]] std::optional<WebSession> session_of(const Request& request);
  // Answers the request for a session by a link.
  [[nodiscard]] Answer enter_by_link(const std::string& secret);
  [[nodiscard]] boost::asio::awaitable<Answer> enter_by_password(std::string name,
                                                                 std::string password,
                                                                 boost::asio::ip::address from);
  [[nodiscard]] Answer leave(const Request& request);
  // To be called about once a second, with the sessions of the pages that are open. Whose name,
  // role or password has changed is out.
  void tick(const std::vector<std::uint64_t>& open);

 private:
  [[nodiscard]] Answer let_in(Identity identity);
  [[nodiscard]] std::string cookie(const std::string& value, std::chrono::seconds age) const;
  void end_where(const Sessions::Condition& condition);

  Scheme scheme_;
  OnEnd on_end_;
  std::string cookie_name_ = "stanok-session";
  Sessions sessions_;
  OneTimeLinks links_;
  LoginDesk logins_;
};

}  // namespace stanok::web
