#include "daemon/server/session_list.h"

#include <algorithm>

#include "base/place.h"

namespace stanok::daemon {

void SessionList::forget(int id) {
  sessions_.erase(id);
  count_places();
}

void SessionList::count_places() {
  places_taken_ = checked_size(std::ranges::count_if(
      sessions_, [](const auto& entry) { return entry.second->has_place(); }));
}

std::vector<std::shared_ptr<Session>> SessionList::all() const {
  std::vector<std::shared_ptr<Session>> all;
  all.reserve(sessions_.size());
  for (const auto& [id, session] : sessions_) all.push_back(session);
  return all;
}

bool SessionList::make_room() {
  const auto observer = oldest([](const Session& session) {
    return session.has_place() && session.role() == protocol::Role::observer;
  });
  if (observer == nullptr) return false;
  observer->drop("E9008", "the connection was closed to make room for an operator");
  return true;
}

bool SessionList::end_oldest_turned_away(Session::Time now) {
  const auto session = oldest([&](const Session& one) { return one.may_be_ended(now); });
  if (session == nullptr) return false;
  session->close();
  return true;
}

std::shared_ptr<Session> SessionList::oldest(const Condition& condition) const {
  const auto found =
      std::ranges::find_if(sessions_, [&](const auto& entry) { return condition(*entry.second); });
  return found == sessions_.end() ? nullptr : found->second;
}

}  // namespace stanok::daemon
