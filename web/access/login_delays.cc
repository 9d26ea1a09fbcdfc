#include "web/access/login_delays.h"

#include <algorithm>

namespace stanok::web {

bool LoginDelays::begin(const std::string& place) {
  if (under_way_.size() >= logins_max) return false;
  return under_way_.insert(place).second;
}

std::chrono::milliseconds LoginDelays::note_failure(const std::string& place, Time now) {
  forget_old(now);
  Failures& failures = failures_[place];
  failures.last = now;
  constexpr int doublings_max = 6;
  const int doublings = std::min(failures.count++, doublings_max);
  return std::min<std::chrono::milliseconds>(first_delay * (1 << doublings), delay_max);
}

void LoginDelays::forget_old(Time now) {
  std::erase_if(failures_,
                [&](const auto& item) { return now - item.second.last > forgotten_after; });
  if (failures_.size() < places_max) return;
  failures_.erase(
      std::min_element(failures_.begin(), failures_.end(),
                       [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
}

}  // namespace stanok::web
