#include "daemon/server/frame_turns.h"

#include <algorithm>
#include <utility>

namespace stanok::daemon {

void FrameTurns::add(int session, Precedence precedence, Task task) {
  Account& account = accounts_[session];
  account.precedence = precedence;
  if (account.tasks.empty()) account.spent = std::max(account.spent, begun_);
  account.tasks.push_back(std::move(task));
  ++waiting_;
}

FrameTurns::Accounts::iterator FrameTurns::cheapest(Precedence precedence) {
  auto found = accounts_.end();
  for (auto at = accounts_.begin(); at != accounts_.end(); ++at) {
    const Account& account = at->second;
    if (account.tasks.empty() || account.precedence != precedence) continue;
    if (found == accounts_.end() || account.spent < found->second.spent) found = at;
  }
  return found;
}

std::optional<FrameTurns::Turn> FrameTurns::next() {
  auto chosen = cheapest(Precedence::works);
  const auto behind = cheapest(Precedence::looks_on);
  const bool has_both = chosen != accounts_.end() && behind != accounts_.end();
  if (chosen == accounts_.end() || (has_both && works_in_a_row_ >= works_in_a_row_max))
    chosen = behind;
  if (chosen == accounts_.end()) return std::nullopt;
  Account& account = chosen->second;
  works_in_a_row_ = account.precedence == Precedence::works ? works_in_a_row_ + 1 : 0;
  begun_ = account.spent;
  Turn turn{.session = chosen->first, .task = std::move(account.tasks.front())};
  account.tasks.pop_front();
  --waiting_;
  return turn;
}

void FrameTurns::charge(int session, Cost cost) {
  const auto found = accounts_.find(session);
  if (found != accounts_.end()) found->second.spent += cost;
}

}  // namespace stanok::daemon
