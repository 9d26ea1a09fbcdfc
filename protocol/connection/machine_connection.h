// MachineConnection: the Unix socket of the daemon, line by line, without waiting in a thread.
#pragma once

#include <array>
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "protocol/contract/frame_reader.h"

namespace stanok::protocol {

class MachineConnection {
 public:
  // An answer of the daemon that is longer than this is not passed on.
  static constexpr std::size_t line_bytes_max = 16U << 20;

  explicit MachineConnection(const boost::asio::any_io_executor& executor)
      : socket_(executor),
        frames_(line_bytes_max),
        turn_(executor, boost::asio::steady_timer::time_point::max()) {}

  // False: nobody listens there, or it has been closed.
  [[nodiscard]] boost::asio::awaitable<bool> connect(const std::filesystem::path& socket);
  // The next line without its end; nothing: the connection has ended, or a line was too long.
  [[nodiscard]] boost::asio::awaitable<std::optional<std::string>> next_line();
  // False: the connection has ended. The line comes without its end. Several may send: lines stay
  // whole.
  [[nodiscard]] boost::asio::awaitable<bool> send(std::string line);
  // At once and for ever; what is under way on it fails.
  void close();

 private:
  boost::asio::local::stream_protocol::socket socket_;
  protocol::FrameReader frames_;
  std::array<char, 65536> received_{};
  bool is_closed_ = false;
  bool is_sending_ = false;
  boost::asio::steady_timer turn_;  // cancelled when the next one may send
};

// Closes a connection when the time of a timer has come, unless that is cancelled before.
void close_when_over(boost::asio::steady_timer& patience,
                     const std::shared_ptr<MachineConnection>& connection);

}  // namespace stanok::protocol
