// DaemonProbe: whether a daemon answers, and what its machine is called.
//
// Asks by a connection that says nothing, at most once a second: a connection takes a place of the
// daemon. One thread.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <chrono>
#include <filesystem>
#include <string>

namespace stanok::web {

class DaemonProbe {
 public:
  explicit DaemonProbe(std::filesystem::path socket);

  [[nodiscard]] boost::asio::awaitable<bool> daemon_answers();
  // As the daemon said last; before that, as its socket is called.
  [[nodiscard]] const std::string& machine() const { return machine_; }
  [[nodiscard]] const std::filesystem::path& socket() const { return socket_; }

 private:
  static constexpr auto good_for = std::chrono::seconds(1);

  std::filesystem::path socket_;
  std::string machine_;
  bool answered_ = false;
  std::chrono::steady_clock::time_point asked_{};
};

}  // namespace stanok::web
