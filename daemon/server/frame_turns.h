// FrameTurns: whose request is answered next.
//
// Who may work the machine comes before those who look on, so that a machine is worked as well with
// fifty observers as with none; behind eight requests of the former one of the latter is answered.
// Among equals it is the session that has cost least: time that answers took counts, not their
// number (start-time fair queueing, P. Goyal and others, 1997). Requests of one session keep their
// order. One thread.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <optional>

namespace stanok::daemon {

enum class Precedence { works, looks_on };

class FrameTurns {
 public:
  using Cost = std::chrono::steady_clock::duration;
  using Task = std::function<void()>;
  static constexpr int works_in_a_row_max = 8;

  // The precedence is that of the session from now on.
  void add(int session, Precedence precedence, Task task);
  struct Turn {
    int session = 0;
    Task task;
  };
  // Nothing: nobody waits.
  [[nodiscard]] std::optional<Turn> next();
  // What the turn of a session has cost.
  void charge(int session, Cost cost);
  // Behind its last turn.
  void forget(int session) { accounts_.erase(session); }
  [[nodiscard]] bool has_waiting() const { return waiting_ > 0; }

 private:
  struct Account {
    Precedence precedence = Precedence::looks_on;
    Cost spent{};
    std::deque<Task> tasks;
  };
  using Accounts = std::map<int, Account>;
  // Who has cost least of those who wait; end: nobody does.
  [[nodiscard]] Accounts::iterator cheapest(Precedence precedence);

  Accounts accounts_;
  Cost begun_{};  // what the session of the last turn had spent: nobody saves up by silence
  std::size_t waiting_ = 0;
  int works_in_a_row_ = 0;
};

}  // namespace stanok::daemon
