#include "web/server/daemon_probe.h"

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "protocol/json_rpc.h"
#include "web/machine/machine_connection.h"

namespace stanok::web {

namespace asio = boost::asio;
using nlohmann::json;

DaemonProbe::DaemonProbe(std::filesystem::path socket)
    : socket_(std::move(socket)), machine_(socket_.stem().string()) {}

asio::awaitable<bool> DaemonProbe::daemon_answers() {
  const auto now = std::chrono::steady_clock::now();
  if (asked_ != decltype(asked_){} && now - asked_ < good_for) co_return answered_;
  asked_ = now;
  const auto executor = co_await asio::this_coro::executor;
  const auto connection = std::make_shared<MachineConnection>(executor);
  asio::steady_timer patience(executor, good_for);
  patience.async_wait([waits = std::weak_ptr(connection)](const boost::system::error_code& error) {
    const auto alive = waits.lock();
    if (!error && alive) alive->close();
  });
  const bool is_connected = co_await connection->connect(socket_);
  std::optional<std::string> line;
  if (is_connected) line = co_await connection->next_line();
  patience.cancel();
  const json hello = line ? protocol::json_from_text(*line) : json();
  answered_ = hello.is_object();
  if (answered_ && hello.contains("params")) machine_ = hello["params"].value("machine", machine_);
  co_return answered_;
}

}  // namespace stanok::web
