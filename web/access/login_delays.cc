#include "web/access/login_delays.h"

#include <algorithm>

namespace stanok::web {

LoginDelays::Time LoginDelays::next_try(const Claimant& claimant, Time now) const {
  const auto found = failures_.find(claimant);
  return found == failures_.end() ? now : found->second.next_try;
}

std::chrono::milliseconds LoginDelays::note_failure(const Claimant& claimant, Time now) {
  forget_old(now);
  Failures& failures = failures_[claimant];
  constexpr int doublings_max = 6;
  const int doublings = std::min(failures.count++, doublings_max);
  const auto delay = std::min<std::chrono::milliseconds>(first_delay * (1 << doublings), delay_max);
  failures.last = now;
  failures.next_try = now + delay;
  return delay;
}

void LoginDelays::forget_old(Time now) {
  std::erase_if(failures_,
                [&](const auto& item) { return now - item.second.last > forgotten_after; });
  if (failures_.size() < claimants_max) return;
  failures_.erase(
      std::min_element(failures_.begin(), failures_.end(),
                       [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
}

}  // namespace stanok::web
