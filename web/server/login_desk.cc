#include "web/server/login_desk.h"

#include <spdlog/spdlog.h>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>

#include "web/access/password.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
namespace fs = std::filesystem;

fs::file_time_type time_of_change(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? fs::file_time_type{} : time;
}

// Of IPv6 the network part; a socket for both shows the addresses of IPv4 as some of IPv6.
std::string network_place(const asio::ip::address& from) {
  if (!from.is_v6()) return from.to_string();
  if (from.to_v6().is_v4_mapped())
    return asio::ip::make_address_v4(asio::ip::v4_mapped, from.to_v6()).to_string();
  auto bytes = from.to_v6().to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
  return asio::ip::address_v6(bytes).to_string();
}

// Values of its own: it runs in another thread.
asio::awaitable<bool> compare_in_thread(std::string hash, std::string password) {
  co_return is_password_of(hash, password);
}

}  // namespace

LoginDesk::LoginDesk(fs::path file) : file_(std::move(file)) {
  if (file_.empty()) return;
  nobody_ = hash_of_nobody();
  read_at_ = time_of_change(file_);
  users_ = UserList::from_file(file_);
}

asio::awaitable<LoginDesk::Outcome> LoginDesk::log_in(std::string name, std::string password,
                                                      asio::ip::address from) {
  using std::chrono::steady_clock;
  const Outcome busy{.identity = {}, .refusal = Refusal::busy};
  if (!has_users() || password.size() > password_bytes_max) co_return Outcome{};
  // All names that nobody can have are one.
  const std::string shown = defect_of_name(name).empty() ? name : "?";
  const Claimant claimant{shown, network_place(from)};
  const auto now = steady_clock::now();
  if (delays_.next_try(claimant, now) > now) co_return busy;
  const auto entered = turns_.enter(claimant);
  if (!entered) co_return busy;
  const bool has_turn = co_await wait_for_turn(*entered);
  if (!has_turn) co_return busy;
  auto identity = co_await compare(std::move(name), std::move(password));
  turns_.leave();
  call_next();
  if (identity) {
    delays_.note_success(claimant);
    co_return Outcome{.identity = std::move(identity)};
  }
  const auto delay = delays_.note_failure(claimant, steady_clock::now());
  spdlog::warn("a login as {} from {} failed", shown, claimant.place);
  asio::steady_timer timer(co_await asio::this_coro::executor, delay);
  static_cast<void>(co_await timer.async_wait(asio::as_tuple(asio::use_awaitable)));
  co_return Outcome{};
}

asio::awaitable<bool> LoginDesk::wait_for_turn(const LoginTurns::Entered& entered) {
  Waiting waiting{.bell = asio::steady_timer(co_await asio::this_coro::executor,
                                             asio::steady_timer::time_point::max())};
  waiting_[entered.ticket] = &waiting;
  if (entered.pushed_out) ring(*entered.pushed_out, &Waiting::is_pushed_out);
  call_next();
  while (!waiting.is_called && !waiting.is_pushed_out)
    static_cast<void>(co_await waiting.bell.async_wait(asio::as_tuple(asio::use_awaitable)));
  waiting_.erase(entered.ticket);
  co_return waiting.is_called;
}

void LoginDesk::call_next() {
  if (const auto ticket = turns_.next()) ring(*ticket, &Waiting::is_called);
}

void LoginDesk::ring(LoginTurns::Ticket ticket, bool Waiting::* what) {
  const auto found = waiting_.find(ticket);
  if (found == waiting_.end()) return;
  found->second->*what = true;
  found->second->bell.cancel();
}

asio::awaitable<std::optional<Identity>> LoginDesk::compare(std::string name,
                                                            std::string password) {
  const User* found = users_.find(name);
  const std::string hash = found == nullptr ? nobody_ : found->password_hash;
  bool is_right = false;
  try {
    is_right = co_await asio::co_spawn(hashing_, compare_in_thread(hash, std::move(password)),
                                       asio::use_awaitable);
  } catch (const std::exception& fault) {
    spdlog::error("a password could not be checked: {}", fault.what());
  }
  // The list may be another one by now.
  const User* user = users_.find(name);
  if (!is_right || user == nullptr || user->password_hash != hash) co_return std::nullopt;
  co_return Identity{name, user->role, hash};
}

bool LoginDesk::look_at_file() {
  if (file_.empty() || time_of_change(file_) == read_at_) return false;
  read_at_ = time_of_change(file_);
  try {
    users_ = UserList::from_file(file_);
  } catch (const std::runtime_error& error) {
    spdlog::error("{}; the users remain unchanged", error.what());
    return false;
  }
  spdlog::info("{} users", users_.users().size());
  return true;
}

bool LoginDesk::knows(const Identity& identity) const {
  if (identity.password_hash.empty()) return true;  // came by a link
  const User* user = users_.find(identity.name);
  return user != nullptr && user->role == identity.role &&
         user->password_hash == identity.password_hash;
}

}  // namespace stanok::web
