// MachineReader: follows one daemon over its socket and keeps board and outbox up to date.
//
// It asks as an observer, gives the daemon no reason to wait, and begins anew whenever the
// connection ends. All readers share one thread with the outbox; publishing and databases have
// threads of their own.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "gateway/cell/event_source.h"
#include "gateway/cell/state_board.h"
#include "protocol/connection/machine_connection.h"

namespace stanok::gateway {

struct MachineAddress {
  std::string name;  // in topics and history
  std::filesystem::path socket;
};

class MachineReader {
 public:
  MachineReader(const boost::asio::any_io_executor& executor, MachineAddress address,
                std::string prefix, double rate_hz, Outbox& outbox, StateBoard& board);

  // For ever.
  [[nodiscard]] boost::asio::awaitable<void> run();

 private:
  using Clock = std::chrono::steady_clock;

  // Until the connection ends.
  [[nodiscard]] boost::asio::awaitable<void> follow();
  [[nodiscard]] boost::asio::awaitable<void> greet();
  // The result, notifications being taken meanwhile. Throws when the connection ends, and for a
  // refusal.
  [[nodiscard]] boost::asio::awaitable<nlohmann::json> ask(std::string method,
                                                           nlohmann::json parameters);
  [[nodiscard]] boost::asio::awaitable<nlohmann::json> next_message();
  [[nodiscard]] boost::asio::awaitable<void> read_history();
  // Of the text of a program; empty where there is none.
  [[nodiscard]] boost::asio::awaitable<std::string> version_of(std::string program);

  void take_notification(const nlohmann::json& message);
  void take_status(const nlohmann::json& parameters);
  // Whether the history has something new.
  void look_for_changes();
  void count_tools();
  void show_status();
  void show(std::string_view topic, nlohmann::json content);

  boost::asio::any_io_executor executor_;
  MachineAddress address_;
  std::string prefix_;
  double rate_hz_;
  StateBoard& board_;
  EventSource events_;
  std::shared_ptr<protocol::MachineConnection> connection_;
  int last_id_ = 0;
  nlohmann::json state_;     // as subscribed to
  nlohmann::json followed_;  // what of it tells of runs and alarms
  bool is_history_new_ = true;
  Clock::time_point read_{};     // the history
  Clock::time_point counted_{};  // the time of tools
};

}  // namespace stanok::gateway
