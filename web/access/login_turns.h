// LoginTurns: whose password is compared next: one at a time, since each costs 64 MiB and a tenth
// of a second, and places by turns.
//
// However many guess, who comes from another place waits for one of each place at most. Where too
// many wait the newest of the place with most of them goes. Of one name from one place one waits.
// One thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "web/access/login_delays.h"

namespace stanok::web {

class LoginTurns {
 public:
  using Ticket = std::uint64_t;
  static constexpr std::size_t waiting_max = 128;

  struct Entered {
    Ticket ticket = 0;
    std::optional<Ticket> pushed_out;  // who had to make room: this one itself at times
  };
  // Nothing: somebody of that name waits or is compared there already.
  [[nodiscard]] std::optional<Entered> enter(const Claimant& claimant);
  // Whose turn it is; nothing: nobody waits, or somebody is being compared.
  [[nodiscard]] std::optional<Ticket> next();
  // Who was called is through.
  void leave();

 private:
  struct Waiting {
    Ticket ticket = 0;
    Claimant claimant;
  };
  [[nodiscard]] std::optional<Ticket> make_room();

  std::map<std::string, std::deque<Waiting>> places_;  // without empty ones
  std::set<Claimant> present_;                         // who waits or is compared
  std::optional<Waiting> called_;
  std::string last_place_;
  std::size_t waiting_ = 0;
  Ticket last_ticket_ = 0;
};

}  // namespace stanok::web
