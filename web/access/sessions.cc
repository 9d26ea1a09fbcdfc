#include "web/access/sessions.h"

#include <algorithm>

namespace stanok::web {

Sessions::Begun Sessions::begin(Identity identity, Time now) {
  Begun begun{.secret = new_secret(), .key = new_secret(), .ended = {}};
  if (entries_.size() >= sessions_max) {
    const auto away = std::min_element(
        entries_.begin(), entries_.end(),
        [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    begun.ended = away->second.session.id;
    entries_.erase(away);
  }
  entries_[hash_of(begun.secret)] = {
      {++last_id_, std::move(identity), hash_of(begun.key)}, now, now};
  return begun;
}

void Sessions::note_use(const std::vector<std::uint64_t>& ids, Time now) {
  for (auto& [hash, entry] : entries_) {
    if (std::ranges::find(ids, entry.session.id) != ids.end()) entry.used = now;
  }
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

std::vector<KeptSession> Sessions::kept(Time now, KeptSession::Time wall_now) const {
  const auto on_wall = [&](Time time) {
    return wall_now - std::chrono::duration_cast<KeptSession::Time::duration>(now - time);
  };
  std::vector<KeptSession> kept;
  kept.reserve(entries_.size());
  for (const auto& [hash, entry] : entries_)
    kept.push_back({hash, entry.session.key, entry.session.identity, on_wall(entry.begun),
                    on_wall(entry.used)});
  return kept;
}

void Sessions::restore(const std::vector<KeptSession>& kept, Time now, KeptSession::Time wall_now) {
  const auto steady = [&](KeptSession::Time time) {
    return now - (wall_now - std::min(time, wall_now));
  };
  for (const KeptSession& one : kept) {
    Entry entry{{++last_id_, one.identity, one.key}, steady(one.begun), steady(one.used)};
    const bool has_room = entries_.size() < sessions_max;
    if (has_room && !is_over(entry, now)) entries_[one.secret] = std::move(entry);
  }
}

bool Sessions::is_over(const Entry& entry, Time now) {
  return now - entry.used > idle_max || now - entry.begun > age_max;
}

}  // namespace stanok::web
