#include "web/server/authentication.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "web/access/private_file.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
namespace fs = std::filesystem;

// The last use of a session is kept this exactly.
constexpr auto keeping_period = std::chrono::minutes(10);

std::chrono::steady_clock::time_point now() {
  return std::chrono::steady_clock::now();
}

// Who could ask for a link runs the server, and may do what it may.
Identity identity_of_link() {
  return {.name = "uid " + std::to_string(getuid()),
          .role = protocol::Role::integrator,
          .password_hash = {}};
}

void write(const fs::path& file, const std::string& text) {
  if (file.empty()) return;
  try {
    write_private_file(file, text);
  } catch (const std::runtime_error& error) {
    spdlog::error("{}; sessions would be lost on a restart", error.what());
  }
}

// Values of its own: it runs in another thread.
asio::awaitable<void> write_in_thread(fs::path file, std::string text) {
  write(file, text);
  co_return;
}

}  // namespace

Authentication::Authentication(Scheme scheme, fs::path users, fs::path sessions, OnEnd on_end)
    : scheme_(scheme),
      on_end_(std::move(on_end)),
      logins_(std::move(users)),
      file_(std::move(sessions)) {
  restore();
}

Authentication::~Authentication() {
  writing_.join();
  write(file_, text_of(sessions_.kept(now(), std::chrono::system_clock::now())));
}

void Authentication::restore() {
  if (file_.empty()) return;
  std::error_code ignored;
  if (file_.has_parent_path()) fs::create_directories(file_.parent_path(), ignored);
  try {
    sessions_.restore(sessions_from_file(file_), now(), std::chrono::system_clock::now());
  } catch (const std::runtime_error& error) {
    spdlog::error("{}; all users have to sign in again", error.what());
  }
  // Who was removed or changed meanwhile. No page is open yet.
  const auto is_unknown = [&](const WebSession& one) { return !logins_.knows(one.identity); };
  static_cast<void>(sessions_.end_where(is_unknown, now()));
}

asio::awaitable<void> Authentication::keeping() {
  kept_at_ = now();
  return write_in_thread(file_,
                         text_of(sessions_.kept(kept_at_, std::chrono::system_clock::now())));
}

asio::awaitable<void> Authentication::keep() {
  co_await asio::co_spawn(writing_, keeping(), asio::use_awaitable);
}

void Authentication::set_port(unsigned short port) {
  cookie_name_ = "stanok-session-" + std::to_string(port);
}

std::string Authentication::issue_link() {
  return links_.issue(now());
}

std::optional<WebSession> Authentication::session_of(const Request& request) {
  constexpr auto field_of_key = "X-Stanok-Key";
  auto session = session_of_cookie(request);
  const auto key = request[field_of_key];
  // Without one it is an address that somebody typed.
  if (!session || key.empty() || !is_key_of(*session, {key.data(), key.size()}))
    return std::nullopt;
  return session;
}

bool Authentication::is_key_of(const WebSession& session, std::string_view key) {
  if (session.is_key(key)) return true;
  spdlog::warn("the cookie of {} was sent without its key; the session ends",
               session.identity.name);
  end(session);
  asio::co_spawn(writing_, keeping(), asio::detached);
  return false;
}

void Authentication::end(const WebSession& session) {
  end_where([&](const WebSession& other) { return other.id == session.id; });
}

std::optional<WebSession> Authentication::session_of_cookie(const Request& request) {
  const std::string secret = cookie_of(request, cookie_name_);
  return secret.empty() ? std::nullopt : sessions_.find(secret, now());
}

asio::awaitable<Answer> Authentication::enter_by_link(const Request& request, std::string secret) {
  if (links_.use_up(secret, now())) co_return co_await let_in(request, identity_of_link());
  spdlog::warn("a login link was already used, too old or wrong");
  co_return refusal(Status::unauthorized,
                    "this link is already used or too old; get another one with `stanok panel`");
}

asio::awaitable<Answer> Authentication::enter_by_password(const Request& request, std::string name,
                                                          std::string password,
                                                          asio::ip::address from) {
  auto outcome = co_await logins_.log_in(std::move(name), std::move(password), std::move(from));
  if (outcome.identity) co_return co_await let_in(request, std::move(*outcome.identity));
  if (outcome.refusal == LoginDesk::Refusal::busy)
    co_return refusal(Status::too_many_requests, "another login is in progress; try again");
  co_return refusal(Status::unauthorized, "wrong name or password");
}

asio::awaitable<Answer> Authentication::let_in(const Request& request, Identity identity) {
  // One browser, one session: pages of an earlier one would go on in its role.
  if (const auto before = session_of_cookie(request)) end(*before);
  spdlog::info("session of {} begins as {}", identity.name, protocol::role_name(identity.role));
  const auto begun = sessions_.begin(std::move(identity), now());
  if (begun.ended) on_end_({*begun.ended});
  co_await keep();
  Answer answer = json_answer(Status::ok, {{"key", begun.key}});
  answer.fields.emplace_back(Field::set_cookie, cookie(begun.secret, Sessions::age_max));
  co_return answer;
}

asio::awaitable<Answer> Authentication::leave(const Request& request) {
  const auto session = session_of(request);
  if (!session) co_return refusal(Status::unauthorized, "no session");
  spdlog::info("session of {} ends", session->identity.name);
  end(*session);
  co_await keep();
  co_return Answer{.status = Status::no_content,
                   .fields = {{Field::set_cookie, cookie("", std::chrono::seconds(0))}}};
}

void Authentication::tick(const std::vector<std::uint64_t>& open) {
  sessions_.note_use(open, now());
  const bool has_changed = logins_.look_at_file();
  const bool has_ended = end_where(
      [&](const WebSession& session) { return has_changed && !logins_.knows(session.identity); });
  if (!has_ended && now() - kept_at_ < keeping_period) return;
  // However long the disk takes: users are looked at again in a second.
  asio::co_spawn(writing_, keeping(), asio::detached);
}

bool Authentication::end_where(const Sessions::Condition& condition) {
  const auto ended = sessions_.end_where(condition, now());
  if (!ended.empty()) on_end_(ended);
  return !ended.empty();
}

std::string Authentication::cookie(const std::string& value, std::chrono::seconds age) const {
  return cookie_name_ + '=' + value + "; Path=/; Max-Age=" + std::to_string(age.count()) +
         "; HttpOnly; SameSite=Strict" + (scheme_ == Scheme::https ? "; Secure" : "");
}

}  // namespace stanok::web
