#include "web/cell/machine_list.h"

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace stanok::web {
namespace {

namespace asio = boost::asio;
using nlohmann::json;

// What all machines say to one question, each in its place.
struct Round {
  std::vector<json> summaries;
  std::size_t awaited;
  std::exception_ptr fault;  // of one of them
  asio::steady_timer over;   // cancelled when the last one has answered or has been given up

  Round(std::size_t count, const asio::any_io_executor& executor)
      : summaries(count), awaited(count), over(executor, asio::steady_timer::time_point::max()) {}
};

}  // namespace

MachineList::MachineList(const std::vector<std::filesystem::path>& sockets)
    : machines_(sockets.begin(), sockets.end()) {}

MachineGlance* MachineList::find(std::string_view id) {
  if (id.empty()) return &first();
  const auto machine =
      std::ranges::find_if(machines_, [&](const auto& one) { return one.id() == id; });
  return machine == machines_.end() ? nullptr : &*machine;
}

// All at once: one that is silent is waited for as long as all that are.
asio::awaitable<json> MachineList::overview() {
  const auto executor = co_await asio::this_coro::executor;
  const auto round = std::make_shared<Round>(machines_.size(), executor);
  for (std::size_t k = 0; k < machines_.size(); ++k) {
    const auto take = [round, k](const std::exception_ptr& fault, json summary) {
      if (fault) round->fault = fault;
      round->summaries[k] = std::move(summary);
      if (--round->awaited == 0) round->over.cancel();
    };
    asio::co_spawn(executor, machines_[k].summary(), take);
  }
  while (round->awaited > 0)
    static_cast<void>(co_await round->over.async_wait(asio::as_tuple(asio::use_awaitable)));
  if (round->fault) std::rethrow_exception(round->fault);
  co_return json(std::move(round->summaries));
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
             " may contain only letters, digits, '-', '_' and '.' when several machines are shown";
    if (!names.insert(name).second)
      return "two sockets have the name " + name +
             "; each machine needs a socket with its own name";
  }
  return {};
}

}  // namespace stanok::web
