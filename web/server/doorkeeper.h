// Doorkeeper: lets visitors in by a one-time link, and knows them by their cookie.
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

namespace stanok::web {

class Doorkeeper {
 public:
  using OnEnd = std::function<void(const std::vector<std::uint64_t>& sessions)>;

  // `on_end` is told the sessions that have ended.
  Doorkeeper(Scheme scheme, OnEnd on_end);

  // Cookies are those of a host, not of a port: servers beside each other need different names.
  void set_port(unsigned short port);

  [[nodiscard]] std::string issue_link();
  [[nodiscard]] std::optional<WebSession> session_of(const Request& request);
  // Answers the request for a session by a link.
  [[nodiscard]] Answer enter_by_link(const std::string& secret);
  [[nodiscard]] Answer leave(const Request& request);
  // To be called about once a second.
  void tick();

 private:
  [[nodiscard]] Answer let_in(Visitor visitor);
  [[nodiscard]] std::string cookie(const std::string& value, std::chrono::seconds age) const;
  void end_where(const Sessions::Condition& condition);

  Scheme scheme_;
  OnEnd on_end_;
  std::string cookie_name_ = "stanok-session";
  Sessions sessions_;
  OneTimeLinks links_;
};

}  // namespace stanok::web
