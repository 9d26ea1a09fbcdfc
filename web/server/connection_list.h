// ConnectionList: the connections that there are, within their bound.
//
// When all places are taken, the connection that has asked nothing for longest makes room; pages
// that are open keep theirs. One thread.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "protocol/contract/method_table.h"
#include "web/server/client_connection.h"

namespace stanok::web {

class ConnectionList {
 public:
  using Time = ClientConnection::Time;
  static constexpr std::size_t connections_max = 256;
  static constexpr std::size_t relays_max = 60;  // the daemon has 64 places
  // The rest is for those who work the machine, however many look on.
  static constexpr std::size_t relays_of_observers_max = 50;

  // Makes room before; false: there is none.
  [[nodiscard]] bool make_room_for_one();
  // Ends the connection that has asked nothing for longest, but no page that is open.
  void end_idlest();
  // Its id, for `forget`; the list keeps nothing alive.
  [[nodiscard]] std::uint64_t add(const std::shared_ptr<ClientConnection>& connection);
  void forget(std::uint64_t id) { connections_.erase(id); }

  [[nodiscard]] bool has_room_for_relay_of(protocol::Role role) const;
  // Of the pages that are open.
  [[nodiscard]] std::vector<std::uint64_t> sessions() const;
  void end_relays_of(const std::vector<std::uint64_t>& sessions);
  // Browsers that do not take what is sent to them.
  void end_stuck(Time now);
  void end_all();

 private:
  using Connections = std::map<std::uint64_t, std::weak_ptr<ClientConnection>>;
  [[nodiscard]] std::vector<std::shared_ptr<ClientConnection>> all() const;
  [[nodiscard]] std::vector<std::shared_ptr<ClientConnection>> relays() const;

  Connections connections_;
  std::uint64_t last_id_ = 0;
};

}  // namespace stanok::web
