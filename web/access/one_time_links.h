// OneTimeLinks: what opens the page once, without a name and a password.
//
// Whoever runs the server on a computer may ask it for a link (web/server/link_desk.h) and hands it
// to a browser there. It is used up by the first who shows it. One thread.
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <string_view>

#include "web/access/secret_text.h"

namespace stanok::web {

class OneTimeLinks {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::size_t links_max = 16;  // the oldest goes first
  static constexpr auto valid_for = std::chrono::hours(1);

  // The secret of a new link.
  [[nodiscard]] std::string issue(Time now);
  // Whether there was such a link; it is gone afterwards.
  [[nodiscard]] bool use_up(std::string_view secret, Time now);

 private:
  struct Link {
    SecretHash hash{};
    Time valid_until{};
  };
  std::deque<Link> links_;
};

}  // namespace stanok::web
