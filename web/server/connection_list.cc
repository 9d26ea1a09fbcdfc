#include "web/server/connection_list.h"

#include <spdlog/spdlog.h>

#include <algorithm>

namespace stanok::web {

bool ConnectionList::make_room_for_one() {
  if (connections_.size() >= connections_max) end_idlest();
  return connections_.size() < connections_max;
}

void ConnectionList::end_idlest() {
  auto idlest = connections_.end();
  auto asked = Time::max();
  for (auto at = connections_.begin(); at != connections_.end(); ++at) {
    const auto connection = at->second.lock();
    if (connection == nullptr || connection->relay() != nullptr || connection->asked() >= asked)
      continue;
    idlest = at;
    asked = connection->asked();
  }
  if (idlest == connections_.end()) return;
  if (const auto connection = idlest->second.lock()) connection->close();
  connections_.erase(idlest);
}

std::uint64_t ConnectionList::add(const std::shared_ptr<ClientConnection>& connection) {
  connections_.emplace(++last_id_, connection);
  return last_id_;
}

std::vector<std::shared_ptr<ClientConnection>> ConnectionList::all() const {
  std::vector<std::shared_ptr<ClientConnection>> alive;
  for (const auto& [id, one] : connections_) {
    if (auto connection = one.lock()) alive.push_back(std::move(connection));
  }
  return alive;
}

std::vector<std::shared_ptr<ClientConnection>> ConnectionList::relays() const {
  auto relays = all();
  std::erase_if(relays, [](const auto& one) { return one->relay() == nullptr; });
  return relays;
}

bool ConnectionList::has_room_for_relay_of(protocol::Role role) const {
  const auto open = relays();
  const auto is_of_observer = [](const auto& one) {
    return one->relay()->session().identity.role == protocol::Role::observer;
  };
  const auto of_observers = static_cast<std::size_t>(std::ranges::count_if(open, is_of_observer));
  return open.size() < relays_max &&
         (role != protocol::Role::observer || of_observers < relays_of_observers_max);
}

std::vector<std::uint64_t> ConnectionList::sessions() const {
  std::vector<std::uint64_t> ids;
  for (const auto& connection : relays()) ids.push_back(connection->relay()->session().id);
  return ids;
}

void ConnectionList::end_relays_of(const std::vector<std::uint64_t>& sessions) {
  for (const auto& connection : relays()) {
    const std::uint64_t session = connection->relay()->session().id;
    if (std::find(sessions.begin(), sessions.end(), session) != sessions.end()) connection->close();
  }
}

void ConnectionList::end_stuck(Time now) {
  for (const auto& connection : relays()) {
    if (!connection->relay()->is_stuck(now)) continue;
    spdlog::warn(
        "a page of {} does not read what it is sent, or does not start; its connection ends",
        connection->relay()->session().identity.name);
    connection->close();
  }
}

void ConnectionList::end_all() {
  for (const auto& connection : all()) connection->close();
}

}  // namespace stanok::web
