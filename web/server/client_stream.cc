#include "web/server/client_stream.h"

#include <boost/asio/bind_executor.hpp>

namespace stanok::web {

ClientStream::ClientStream(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls)
    : tcp_(std::move(socket)) {
  if (tls != nullptr) tls_.emplace(tcp_, *tls);
}

void ClientStream::close() {
  boost::system::error_code ignored;
  ignored = tcp_.socket().close(ignored);
}

// Beast cannot post to the erased executor of an erased handler; there is one for all.
auto ClientStream::here(Handler handler) {
  return boost::asio::bind_executor(
      get_executor(),
      [handler = std::move(handler)](boost::system::error_code error, std::size_t bytes) mutable {
        std::move(handler)(error, bytes);
      });
}

void ClientStream::read(const ReadBuffers& buffers, Handler handler) {
  if (tls_) return tls_->async_read_some(buffers, here(std::move(handler)));
  tcp_.async_read_some(buffers, here(std::move(handler)));
}

void ClientStream::write(const WriteBuffers& buffers, Handler handler) {
  if (tls_) return tls_->async_write_some(buffers, here(std::move(handler)));
  tcp_.async_write_some(buffers, here(std::move(handler)));
}

}  // namespace stanok::web
