// LoginDelays: how long who failed to log in waits for the answer: longer with each failure.
//
// Counted by network address, which is nobody's identity, only the place that guesses come from; of
// IPv6 the network part, since each computer has many addresses there. A login at a time of each.
// One thread.
#pragma once

#include <chrono>
#include <map>
#include <set>
#include <string>

namespace stanok::web {

class LoginDelays {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr auto first_delay = std::chrono::milliseconds(500);
  static constexpr auto delay_max = std::chrono::seconds(16);
  static constexpr auto forgotten_after = std::chrono::minutes(15);
  static constexpr std::size_t places_max = 1024;  // the one that failed longest ago goes first
  static constexpr std::size_t logins_max = 16;    // at a time, of all places

  // False: somebody logs in from there already, or too many do.
  [[nodiscard]] bool begin(const std::string& place);
  // How long the answer is to wait; `end` comes behind that.
  [[nodiscard]] std::chrono::milliseconds note_failure(const std::string& place, Time now);
  void note_success(const std::string& place) { failures_.erase(place); }
  void end(const std::string& place) { under_way_.erase(place); }

 private:
  struct Failures {
    int count = 0;
    Time last{};
  };
  void forget_old(Time now);

  std::map<std::string, Failures> failures_;
  std::set<std::string> under_way_;
};

}  // namespace stanok::web
