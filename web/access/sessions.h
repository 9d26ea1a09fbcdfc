// Sessions: who is let in, on the server's side, so that each can be ended at once.
//
// The browser holds two secrets, the server their hashes: one in a cookie, which the browser sends
// by itself, but to every port of the host; and a key in the storage of this origin, which nothing
// but the page of this very server reads. Who shows the cookie with another key has stolen it. A
// session ends when nobody used it for `idle_max`, after `age_max`, by its own wish, or when its
// user is taken away; a page that is open uses it. Those that outlive the server are measured on
// the wall clock meanwhile. One thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/contract/method_table.h"
#include "web/access/secret_text.h"

namespace stanok::web {

struct Identity {
  std::string name;
  protocol::Role role = protocol::Role::observer;
  // Of the password that let the user in; empty: a one-time link did.
  std::string password_hash;
};

struct WebSession {
  std::uint64_t id = 0;  // never given twice
  Identity identity;
  SecretHash key{};  // of the key

  [[nodiscard]] bool is_key(std::string_view given) const { return hash_of(given) == key; }
};

// A session as it outlives the server.
struct KeptSession {
  using Time = std::chrono::system_clock::time_point;
  SecretHash secret{};
  SecretHash key{};
  Identity identity;
  Time begun{};
  Time used{};
};

class Sessions {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::size_t sessions_max = 1024;  // who has been away longest goes first
  static constexpr auto idle_max = std::chrono::hours(12);
  static constexpr auto age_max = std::chrono::hours(24 * 7);

  struct Begun {
    std::string secret;                  // for the cookie
    std::string key;                     // for the storage of the page
    std::optional<std::uint64_t> ended;  // the session that had to make room
  };
  [[nodiscard]] Begun begin(Identity identity, Time now);
  // Notes that it is used.
  [[nodiscard]] std::optional<WebSession> find(std::string_view secret, Time now);
  // Pages of these sessions are open.
  void note_use(const std::vector<std::uint64_t>& ids, Time now);
  // Ends all that are asked for, and those whose time is over; their ids.
  using Condition = std::function<bool(const WebSession& session)>;
  [[nodiscard]] std::vector<std::uint64_t> end_where(const Condition& condition, Time now);

  // What is to be kept, and where it is taken up again. A time that has not come yet counts as now:
  // somebody has set the clock.
  [[nodiscard]] std::vector<KeptSession> kept(Time now, KeptSession::Time wall_now) const;
  void restore(const std::vector<KeptSession>& kept, Time now, KeptSession::Time wall_now);

 private:
  struct Entry {
    WebSession session;
    Time begun{};
    Time used{};
  };
  [[nodiscard]] static bool is_over(const Entry& entry, Time now);

  std::map<SecretHash, Entry> entries_;
  std::uint64_t last_id_ = 0;
};

}  // namespace stanok::web
