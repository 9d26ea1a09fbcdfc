// MachineGlance: whether a daemon answers, what its machine is called, and what its channels do, as
// an overview of several machines shows it.
//
// Asks by a connection of its own, at most once a second for all who look: a connection takes a
// place of the daemon. One thread.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace stanok::web {

class MachineGlance {
 public:
  explicit MachineGlance(std::filesystem::path socket);

  // By its greeting; nothing is asked.
  [[nodiscard]] boost::asio::awaitable<bool> daemon_answers();
  // What it answered last was that all its places are taken.
  [[nodiscard]] bool is_full() const { return is_full_; }
  // {"id", "name", "answers", "on", "channels": [...]}; `on` null and no channels where it does not
  // answer.
  [[nodiscard]] boost::asio::awaitable<nlohmann::json> summary();
  // How the address of the page names it: as the socket is called.
  [[nodiscard]] std::string id() const { return socket_.stem().string(); }
  // As the daemon said last; before that, as its socket is called.
  [[nodiscard]] const std::string& machine() const { return machine_; }
  [[nodiscard]] const std::filesystem::path& socket() const { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr auto good_for = std::chrono::seconds(1);
  enum class Depth : unsigned char { greeting, state };

  // What the daemon says before it falls silent.
  [[nodiscard]] boost::asio::awaitable<void> look(Depth depth);

  std::filesystem::path socket_;
  std::string machine_;
  bool answers_ = false;
  bool is_full_ = false;
  nlohmann::json status_;    // result of machine.status; null: not answered
  nlohmann::json channels_;  // what is shown of each
  Clock::time_point greeted_{};
  Clock::time_point seen_{};
};

}  // namespace stanok::web
