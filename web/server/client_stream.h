// ClientStream: the connection to a browser, plain or with TLS, as one type for HTTP and WebSocket.
//
// Reads and writes end by themselves at the time that `expires_after` of its TCP stream set.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <optional>
#include <utility>

namespace stanok::web {

class ClientStream {
 public:
  using next_layer_type = boost::beast::tcp_stream;
  using executor_type = next_layer_type::executor_type;
  using Tls = boost::asio::ssl::stream<next_layer_type&>;

  // `tls` outlives the stream; nullptr: without.
  ClientStream(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls)
      : tcp_(std::move(socket)) {
    if (tls != nullptr) tls_.emplace(tcp_, *tls);
  }
  ClientStream(const ClientStream&) = delete;
  ClientStream& operator=(const ClientStream&) = delete;

  [[nodiscard]] next_layer_type& next_layer() { return tcp_; }
  [[nodiscard]] const next_layer_type& next_layer() const { return tcp_; }
  [[nodiscard]] executor_type get_executor() { return tcp_.get_executor(); }
  // nullptr: without TLS.
  [[nodiscard]] Tls* tls() { return tls_ ? &*tls_ : nullptr; }

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    if (tls_) return tls_->async_read_some(buffers, std::forward<Token>(token));
    return tcp_.async_read_some(buffers, std::forward<Token>(token));
  }
  template <class Buffers, class Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    if (tls_) return tls_->async_write_some(buffers, std::forward<Token>(token));
    return tcp_.async_write_some(buffers, std::forward<Token>(token));
  }

  // At once; what is under way on it fails.
  void close() {
    boost::system::error_code ignored;
    ignored = tcp_.socket().close(ignored);
  }

 private:
  next_layer_type tcp_;
  std::optional<Tls> tls_;
};

// How a WebSocket ends; found by Beast.
template <class Handler>
void async_teardown(boost::beast::role_type role, ClientStream& stream, Handler&& handler) {
  using boost::beast::websocket::async_teardown;
  if (stream.tls() != nullptr) {
    async_teardown(role, *stream.tls(), std::forward<Handler>(handler));
  } else {
    async_teardown(role, stream.next_layer().socket(), std::forward<Handler>(handler));
  }
}

}  // namespace stanok::web
