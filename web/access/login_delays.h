// LoginDelays: how long who failed to log in waits for the answer, and the next try: longer with
// each failure.
//
// Counted by name and network address. An address alone is nobody's identity: whole shops come
// through one tunnel, and who guesses there must keep out nobody else; a name alone could be kept
// out from anywhere. Of IPv6 it is the network part, since each computer has many addresses there.
// Who waits holds nothing but this. One thread.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace stanok::web {

// Who tries to log in.
struct Claimant {
  std::string name;
  std::string place;
  friend auto operator<=>(const Claimant&, const Claimant&) = default;
};

class LoginDelays {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr auto first_delay = std::chrono::milliseconds(500);
  static constexpr auto delay_max = std::chrono::seconds(16);
  static constexpr auto forgotten_after = std::chrono::minutes(15);
  static constexpr std::size_t claimants_max = 4096;  // who failed longest ago goes first

  // When the next try is admitted; in the past, or `now`: at once.
  [[nodiscard]] Time next_try(const Claimant& claimant, Time now) const;
  // How long the answer is to wait, and the next try with it.
  [[nodiscard]] std::chrono::milliseconds note_failure(const Claimant& claimant, Time now);
  // Forgets the failures of that name from there, and no others.
  void note_success(const Claimant& claimant) { failures_.erase(claimant); }

 private:
  struct Failures {
    int count = 0;
    Time last{};
    Time next_try{};
  };
  void forget_old(Time now);

  std::map<Claimant, Failures> failures_;
};

}  // namespace stanok::web
