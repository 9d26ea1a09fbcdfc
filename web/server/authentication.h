// Authentication: lets users in by a one-time link or a password, and knows them by a cookie and a
// key (web/access/sessions.h), which a request shows in the field X-Stanok-Key and a WebSocket in
// its first message.
//
// Sessions outlive the server in a file, which a thread of its own writes before an answer tells of
// them. One thread.
#pragma once

#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "web/access/one_time_links.h"
#include "web/access/session_file.h"
#include "web/access/sessions.h"
#include "web/server/answer.h"
#include "web/server/login_desk.h"

namespace stanok::web {

class Authentication {
 public:
  using OnEnd = std::function<void(const std::vector<std::uint64_t>& sessions)>;

  // `on_end` is told the sessions that have ended; an empty name of the file of the sessions: none
  // outlives the server. Throws std::runtime_error when the users cannot be read.
  Authentication(Scheme scheme, std::filesystem::path users, std::filesystem::path sessions,
                 OnEnd on_end);
  ~Authentication();
  Authentication(const Authentication&) = delete;
  Authentication& operator=(const Authentication&) = delete;

  [[nodiscard]] bool has_users() const { return logins_.has_users(); }

  // Cookies are those of a host, not of a port: servers beside each other need different names.
  void set_port(unsigned short port);

  [[nodiscard]] std::string issue_link();
  // By cookie and key. A wrong key ends the session.
  [[nodiscard]] std::optional<WebSession> session_of(const Request& request);
  // Whose cookie it is; nothing is to be told or done before `is_key_of`.
  [[nodiscard]] std::optional<WebSession> session_of_cookie(const Request& request);
  // False: the session has ended, as its cookie has come to somebody else.
  [[nodiscard]] bool is_key_of(const WebSession& session, std::string_view key);
  // Answers the request for a session by a link. The session that the browser had ends.
  [[nodiscard]] boost::asio::awaitable<Answer> enter_by_link(const Request& request,
                                                             std::string secret);
  [[nodiscard]] boost::asio::awaitable<Answer> enter_by_password(const Request& request,
                                                                 std::string name,
                                                                 std::string password,
                                                                 boost::asio::ip::address from);
  [[nodiscard]] boost::asio::awaitable<Answer> leave(const Request& request);
  // To be called about once a second, with the sessions of the pages that are open. Whose name,
  // role or password has changed is out.
  void tick(const std::vector<std::uint64_t>& open);

 private:
  [[nodiscard]] boost::asio::awaitable<Answer> let_in(const Request& request, Identity identity);
  void end(const WebSession& session);
  [[nodiscard]] std::string cookie(const std::string& value, std::chrono::seconds age) const;
  // Whether any ended.
  bool end_where(const Sessions::Condition& condition);
  void restore();
  // Writes the sessions of now, in the thread for it. A fault is told in the log; what is not kept
  // is in force.
  [[nodiscard]] boost::asio::awaitable<void> keeping();
  // Returns when they are on the disk.
  [[nodiscard]] boost::asio::awaitable<void> keep();

  Scheme scheme_;
  OnEnd on_end_;
  std::string cookie_name_ = "stanok-session";
  Sessions sessions_;
  OneTimeLinks links_;
  LoginDesk logins_;
  std::filesystem::path file_;
  std::chrono::steady_clock::time_point kept_at_{};
  boost::asio::thread_pool writing_{1};
};

}  // namespace stanok::web
