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

// Of IPv6 the network part.
std::string network_place(const asio::ip::address& from) {
  if (!from.is_v6()) return from.to_string();
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
  const std::string place = network_place(from);
  if (!has_users() || password.size() > password_bytes_max) co_return Outcome{};
  if (!delays_.begin(place)) co_return Outcome{.identity = {}, .refusal = Refusal::busy};
  Outcome outcome;
  try {
    outcome = co_await judge(name, password, place);
  } catch (...) {
    delays_.end(place);
    throw;
  }
  delays_.end(place);
  co_return outcome;
}

asio::awaitable<LoginDesk::Outcome> LoginDesk::judge(const std::string& name,
                                                     const std::string& password,
                                                     const std::string& place) {
  const User* found = users_.find(name);
  const std::string hash = found == nullptr ? nobody_ : found->password_hash;
  const bool is_right =
      co_await asio::co_spawn(hashing_, compare_in_thread(hash, password), asio::use_awaitable);
  // The list may be another one by now.
  const User* user = users_.find(name);
  if (is_right && user != nullptr && user->password_hash == hash) {
    delays_.note_success(place);
    co_return Outcome{.identity = Identity{name, user->role, hash}};
  }
  const auto delay = delays_.note_failure(place, std::chrono::steady_clock::now());
  spdlog::warn("a login as {} from {} failed", defect_of_name(name).empty() ? name : "?", place);
  asio::steady_timer timer(co_await asio::this_coro::executor, delay);
  static_cast<void>(co_await timer.async_wait(asio::as_tuple(asio::use_awaitable)));
  co_return Outcome{};
}

bool LoginDesk::look_at_file() {
  if (file_.empty() || time_of_change(file_) == read_at_) return false;
  read_at_ = time_of_change(file_);
  try {
    users_ = UserList::from_file(file_);
  } catch (const std::runtime_error& error) {
    spdlog::error("{}; the users are still those of before", error.what());
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
