#include "web/cell/machine_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace stanok::web {

namespace asio = boost::asio;
using nlohmann::json;

MachineList::MachineList(const std::vector<std::filesystem::path>& sockets)
    : machines_(sockets.begin(), sockets.end()) {}

MachineGlance* MachineList::find(std::string_view id) {
  if (id.empty()) return &first();
  const auto machine =
      std::ranges::find_if(machines_, [&](const auto& one) { return one.id() == id; });
  return machine == machines_.end() ? nullptr : &*machine;
}

asio::awaitable<json> MachineList::overview() {
  json machines = json::array();
  for (MachineGlance& machine : machines_) {
    json summary = co_await machine.summary();
    machines.push_back(std::move(summary));
  }
  co_return machines;
}

// What stands in an address of a browser as it is.
std::string confusion(const std::vector<std::filesystem::path>& sockets) {
  constexpr std::string_view permitted =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";
  if (sockets.size() < 2) return {};
  std::set<std::string> names;
  for (const std::filesystem::path& socket : sockets) {
    const std::string name = socket.stem().string();
    if (name.find_first_not_of(permitted) != std::string::npos)
      return "the name of the socket " + socket.string() +
             " may have letters, digits, '-', '_' and '.' only where several machines are shown";
    if (!names.insert(name).second)
      return "two sockets are called " + name + ": a machine is known by the name of its socket";
  }
  return {};
}

}  // namespace stanok::web
