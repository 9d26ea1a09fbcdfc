#include "web/access/sessions.h"

#include <algorithm>

namespace stanok::web {

std::string Sessions::begin(Visitor visitor, Time now) {
  if (entries_.size() >= sessions_max) {
    entries_.erase(std::min_element(
        entries_.begin(), entries_.end(),
        [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
  }
  std::string secret = new_secret();
  entries_[hash_of(secret)] = {{++last_id_, std::move(visitor)}, now, now};
  return secret;
}

std::optional<WebSession> Sessions::find(std::string_view secret, Time now) {
  const auto found = entries_.find(hash_of(secret));
  if (found == entries_.end() || is_over(found->second, now)) return std::nullopt;
  found->second.used = now;
  return found->second.session;
}

std::vector<std::uint64_t> Sessions::end_where(const Condition& condition, Time now) {
  std::vector<std::uint64_t> ended;
  std::erase_if(entries_, [&](const auto& item) {
    const Entry& entry = item.second;
    const bool ends = is_over(entry, now) || condition(entry.session);
    if (ends) ended.push_back(entry.session.id);
    return ends;
  });
  return ended;
}

bool Sessions::is_over(const Entry& entry, Time now) {
  return now - entry.used > idle_max || now - entry.begun > age_max;
}

}  // namespace stanok::web
