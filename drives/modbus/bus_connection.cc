#include "drives/modbus/bus_connection.h"

#include <algorithm>

namespace stanok::drives {
namespace {

constexpr BusTime pause_max = std::chrono::seconds{1};

}  // namespace

BusConnection::Try BusConnection::ensure(const BusClock& clock) {
  if (link_->is_connected()) return Try::stands;
  if (clock.now() < again_at_) return Try::not_yet;
  link_->wait_at_most(timeout_ / 3);
  link_->connect();
  if (link_->is_connected()) return Try::made;
  again_at_ = clock.now() + pause_;
  pause_ = std::min(std::max(2 * pause_, timeout_ / 25), pause_max);
  return Try::failed;
}

}  // namespace stanok::drives
