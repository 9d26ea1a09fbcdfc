// MachineList: the machines that one server shows: the first one as a rule, others by their names.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "web/cell/machine_glance.h"

namespace stanok::web {

class MachineList {
 public:
  // One at least; no two are called alike.
  explicit MachineList(const std::vector<std::filesystem::path>& sockets);

  [[nodiscard]] MachineGlance& first() { return machines_.front(); }
  // By its id; nullptr: there is none. An empty one is the first.
  [[nodiscard]] MachineGlance* find(std::string_view id);
  // What each of them does.
  [[nodiscard]] boost::asio::awaitable<nlohmann::json> overview();

 private:
  std::vector<MachineGlance> machines_;
};

// Why these cannot be told apart by the names of their sockets; empty: they can.
[[nodiscard]] std::string confusion(const std::vector<std::filesystem::path>& sockets);

}  // namespace stanok::web
