// ClientStream: the connection to a browser, plain or with TLS, as one type for HTTP and WebSocket.
//
// Reads and writes end by themselves at the time that `expires_after` of its TCP stream set. What
// they are of TCP and TLS is compiled once, for one kind of buffers and handlers, in
// client_stream.cc: Beast reads and writes with a dozen of each. Handlers are called by the
// executor of the stream.
#pragma once

#include <array>
#include <boost/asio/any_completion_handler.hpp>
#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <cstddef>
#include <optional>
#include <utility>

namespace stanok::web {

// The first buffers of a sequence that are not empty; reads and writes of a part take no more.
template <class Buffer>
class FirstBuffers {
 public:
  template <class Buffers>
  explicit FirstBuffers(const Buffers& buffers) {
    const auto end = boost::asio::buffer_sequence_end(buffers);
    for (auto it = boost::asio::buffer_sequence_begin(buffers); it != end; ++it) {
      const Buffer buffer(*it);
      if (buffer.size() == 0) continue;
      buffers_[count_++] = buffer;
      if (count_ == buffers_.size()) return;
    }
  }

  [[nodiscard]] const Buffer* begin() const { return buffers_.data(); }
  [[nodiscard]] const Buffer* end() const { return buffers_.data() + count_; }

 private:
  std::array<Buffer, 16> buffers_;
  std::size_t count_ = 0;
};

class ClientStream {
 public:
  using next_layer_type = boost::beast::tcp_stream;
  using executor_type = next_layer_type::executor_type;
  using Tls = boost::asio::ssl::stream<next_layer_type&>;

  // `tls` outlives the stream; nullptr: without.
  ClientStream(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls);
  ClientStream(const ClientStream&) = delete;
  ClientStream& operator=(const ClientStream&) = delete;

  [[nodiscard]] next_layer_type& next_layer() { return tcp_; }
  [[nodiscard]] const next_layer_type& next_layer() const { return tcp_; }
  [[nodiscard]] executor_type get_executor() { return tcp_.get_executor(); }
  // nullptr: without TLS.
  [[nodiscard]] Tls* tls() { return tls_ ? &*tls_ : nullptr; }

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return boost::asio::async_initiate<Token, Signature>(
        [this](auto handler, const ReadBuffers& first) { read(first, std::move(handler)); }, token,
        ReadBuffers(buffers));
  }
  template <class Buffers, class Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    return boost::asio::async_initiate<Token, Signature>(
        [this](auto handler, const WriteBuffers& first) { write(first, std::move(handler)); },
        token, WriteBuffers(buffers));
  }

  // At once; what is under way on it fails.
  void close();

 private:
  using Signature = void(boost::system::error_code, std::size_t);
  using Handler = boost::asio::any_completion_handler<Signature>;
  using ReadBuffers = FirstBuffers<boost::asio::mutable_buffer>;
  using WriteBuffers = FirstBuffers<boost::asio::const_buffer>;

  [[nodiscard]] auto here(Handler handler);
  void read(const ReadBuffers& buffers, Handler handler);
  void write(const WriteBuffers& buffers, Handler handler);

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
