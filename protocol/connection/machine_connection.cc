#include "protocol/connection/machine_connection.h"

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>

namespace stanok::protocol {

namespace asio = boost::asio;
using asio::local::stream_protocol;

asio::awaitable<bool> MachineConnection::connect(const std::filesystem::path& socket) {
  const std::string path = socket.string();
  // A longer name does not fit into an address of the system.
  if (is_closed_ || path.size() >= sizeof(sockaddr_un::sun_path)) co_return false;
  const stream_protocol::endpoint endpoint(path);
  const auto [error] =
      co_await socket_.async_connect(endpoint, asio::as_tuple(asio::use_awaitable));
  co_return !error;
}

asio::awaitable<std::optional<std::string>> MachineConnection::next_line() {
  while (true) {
    if (auto frame = frames_.next()) {
      if (frame->kind == protocol::FrameKind::oversize) co_return std::nullopt;
      co_return std::move(frame->text);
    }
    const auto [error, bytes] = co_await socket_.async_read_some(
        asio::buffer(received_), asio::as_tuple(asio::use_awaitable));
    if (error) co_return std::nullopt;
    frames_.append({received_.data(), bytes});
  }
}

asio::awaitable<bool> MachineConnection::send(std::string line) {
  line += '\n';
  while (is_sending_)
    static_cast<void>(co_await turn_.async_wait(asio::as_tuple(asio::use_awaitable)));
  is_sending_ = true;
  const auto [error, bytes] =
      co_await asio::async_write(socket_, asio::buffer(line), asio::as_tuple(asio::use_awaitable));
  is_sending_ = false;
  turn_.cancel();
  co_return !error;
}

void MachineConnection::close() {
  is_closed_ = true;
  boost::system::error_code ignored;
  ignored = socket_.close(ignored);
}

void close_when_over(asio::steady_timer& patience,
                     const std::shared_ptr<MachineConnection>& connection) {
  patience.async_wait([waits = std::weak_ptr(connection)](const boost::system::error_code& error) {
    const auto alive = waits.lock();
    if (!error && alive) alive->close();
  });
}

}  // namespace stanok::protocol
