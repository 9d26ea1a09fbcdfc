#include "web/server/authentication.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <utility>

namespace stanok::web {
namespace {

namespace asio = boost::asio;

std::chrono::steady_clock::time_point now() {
  return std::chrono::steady_clock::now();
}

// Who could ask for a link runs the server, and may do what it may.
Identity identity_of_link() {
  return {.name = "uid " + std::to_string(getuid()),
          .role = protocol::Role::integrator,
          .password_hash = {}};
}

}  // namespace

Authentication::Authentication(Scheme scheme, std::filesystem::path users, OnEnd on_end)
    : scheme_(scheme), on_end_(std::move(on_end)), logins_(std::move(users)) {}

void Authentication::set_port(unsigned short port) {
  cookie_name_ = "stanok-session-" + std::to_string(port);
}

std::string Authentication::issue_link() {
  return links_.issue(now());
}

std::optional<WebSession> Authentication::session_of(const Request& request) {
  const std::string secret = cookie_of(request, cookie_name_);
  return secret.empty() ? std::nullopt : sessions_.find(secret, now());
}

Answer Authentication::enter_by_link(const std::string& secret) {
  if (links_.use_up(secret, now())) return let_in(identity_of_link());
  spdlog::warn("a link was shown that is used up, too old or wrong");
  return refusal(Status::unauthorized,
                 "this link is used up or too old; `stanok panel` prints another one");
}

asio::awaitable<Answer> Authentication::enter_by_password(std::string name, std::string password,
                                                          asio::ip::address from) {
  auto outcome = co_await logins_.log_in(std::move(name), std::move(password), std::move(from));
  if (outcome.identity) co_return let_in(std::move(*outcome.identity));
  if (outcome.refusal == LoginDesk::Refusal::busy)
    co_return refusal(Status::too_many_requests, "another login is under way; try again");
  co_return refusal(Status::unauthorized, "name or password is wrong");
}

Answer Authentication::let_in(Identity identity) {
  spdlog::info("session of {} begins as {}", identity.name, protocol::role_name(identity.role));
  const auto begun = sessions_.begin(std::move(identity), now());
  if (begun.ended) on_end_({*begun.ended});
  return {.status = Status::no_content,
          .fields = {{Field::set_cookie, cookie(begun.secret, Sessions::age_max)}}};
}

Answer Authentication::leave(const Request& request) {
  const auto session = session_of(request);
  if (!session) return refusal(Status::unauthorized, "there is no session");
  spdlog::info("session of {} ends", session->identity.name);
  end_where([&](const WebSession& other) { return other.id == session->id; });
  return {.status = Status::no_content,
          .fields = {{Field::set_cookie, cookie("", std::chrono::seconds(0))}}};
}

void Authentication::tick(const std::vector<std::uint64_t>& open) {
  sessions_.note_use(open, now());
  const bool has_changed = logins_.look_at_file();
  end_where(
      [&](const WebSession& session) { return has_changed && !logins_.knows(session.identity); });
}

void Authentication::end_where(const Sessions::Condition& condition) {
  const auto ended = sessions_.end_where(condition, now());
  if (!ended.empty()) on_end_(ended);
}

std::string Authentication::cookie(const std::string& value, std::chrono::seconds age) const {
  return cookie_name_ + '=' + value + "; Path=/; Max-Age=" + std::to_string(age.count()) +
         "; HttpOnly; SameSite=Strict" + (scheme_ == Scheme::https ? "; Secure" : "");
}

}  // namespace stanok::web
