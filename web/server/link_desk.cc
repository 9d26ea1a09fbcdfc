#include "web/server/link_desk.h"

#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "protocol/contract/json_text.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
using asio::local::stream_protocol;

constexpr ::mode_t only_for_owner = 0177;

void clear_way_for_links(const asio::any_io_executor& executor, const std::filesystem::path& path) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const auto type = std::filesystem::symlink_status(path, error).type();
  if (type == std::filesystem::file_type::not_found) return;
  if (type != std::filesystem::file_type::socket)
    throw std::runtime_error(path.string() + ": this file exists and is not a socket");
  stream_protocol::socket probe(executor);
  boost::system::error_code refused;
  refused = probe.connect(stream_protocol::endpoint(path.string()), refused);
  if (!refused)
    throw std::runtime_error(
        path.string() +
        ": another stanok-web is using this socket; name another one with --link-socket");
  std::filesystem::remove(path, error);
}

bool is_owner(stream_protocol::socket& socket) {
  ucred credentials{};
  socklen_t size = sizeof credentials;
  const bool is_known =
      getsockopt(socket.native_handle(), SOL_SOCKET, SO_PEERCRED, &credentials, &size) == 0;
  return is_known && (credentials.uid == getuid() || credentials.uid == 0);
}

}  // namespace

LinkDesk::LinkDesk(const asio::any_io_executor& executor, std::filesystem::path path,
                   NewLink new_link)
    : path_(std::move(path)), new_link_(std::move(new_link)), acceptor_(executor) {
  clear_way_for_links(executor, path_);
  const ::mode_t mask = ::umask(only_for_owner);
  boost::system::error_code error;
  error = acceptor_.open(stream_protocol(), error);
  if (!error) error = acceptor_.bind(stream_protocol::endpoint(path_.string()), error);
  if (!error) error = acceptor_.listen(asio::socket_base::max_listen_connections, error);
  ::umask(mask);
  if (error) throw std::runtime_error(path_.string() + ": " + error.message());
}

LinkDesk::~LinkDesk() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void LinkDesk::close() {
  boost::system::error_code ignored;
  ignored = acceptor_.close(ignored);
}

asio::awaitable<void> LinkDesk::serve() {
  constexpr auto pause = std::chrono::milliseconds(100);  // when there are no descriptors left
  asio::steady_timer timer(co_await asio::this_coro::executor);
  while (acceptor_.is_open()) {
    auto [error, socket] = co_await acceptor_.async_accept(asio::as_tuple(asio::use_awaitable));
    if (error == asio::error::operation_aborted) co_return;
    if (error) {
      timer.expires_after(pause);
      static_cast<void>(co_await timer.async_wait(asio::as_tuple(asio::use_awaitable)));
      continue;
    }
    if (!is_owner(socket)) continue;
    // Short enough for the buffer of the system: nobody can keep this waiting.
    const std::string line = protocol::json_text(nlohmann::json{{"link", new_link_()}}) + '\n';
    const auto [ignored, bytes] =
        co_await asio::async_write(socket, asio::buffer(line), asio::as_tuple(asio::use_awaitable));
    static_cast<void>(ignored);
    static_cast<void>(bytes);
  }
}

}  // namespace stanok::web
