// LinkDesk: gives one-time links to those who run the server, on a Unix socket of their own.
//
// `stanok panel` asks here: who connects gets one line, {"link": "http://127.0.0.1:8080/#..."}, and
// the end of the connection. Open to the same user and to root only. One thread.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <filesystem>
#include <functional>
#include <string>

namespace stanok::web {

class LinkDesk {
 public:
  using NewLink = std::function<std::string()>;

  // A socket that a server left behind is replaced. Throws std::runtime_error when another server
  // gives links there, or the socket cannot be made.
  LinkDesk(const boost::asio::any_io_executor& executor, std::filesystem::path path,
           NewLink new_link);
  ~LinkDesk();
  LinkDesk(const LinkDesk&) = delete;
  LinkDesk& operator=(const LinkDesk&) = delete;

  // Until `close`; the desk outlives it.
  [[nodiscard]] boost::asio::awaitable<void> serve();
  void close();

 private:
  std::filesystem::path path_;
  NewLink new_link_;
  boost::asio::local::stream_protocol::acceptor acceptor_;
};

}  // namespace stanok::web
