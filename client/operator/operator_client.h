// OperatorClient: a blocking connection to a running daemon over its unix socket.
//
// One thread. Notifications that arrive while an answer is awaited go to the listener, in their
// order. Waiting ends early when the process was interrupted (client/terminal/interrupts.h).
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/expected.h"
#include "protocol/contract/failure.h"
#include "protocol/contract/frame_reader.h"

namespace stanok::client {

// No daemon there, or it went away.
class ConnectionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Somebody pressed Ctrl-C.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// What a connection is for.
enum class ClientPurpose : std::uint8_t {
  anything,
  stop,  // sent at once: for it the daemon needs not greet, nor have a place left
};

class OperatorClient {
 public:
  using Clock = std::chrono::steady_clock;
  using Deadline = std::optional<Clock::time_point>;  // nothing: wait for ever
  using Listener = std::function<void(const std::string& method, const nlohmann::json& parameters)>;

  // Connects and waits for the daemon's hello. A daemon that has no place left still takes stops.
  // Throws ConnectionError.
  explicit OperatorClient(const std::filesystem::path& socket,
                          ClientPurpose purpose = ClientPurpose::anything);
  ~OperatorClient();
  OperatorClient(const OperatorClient&) = delete;
  OperatorClient& operator=(const OperatorClient&) = delete;

  // An object; of a daemon without a place it has the channels alone.
  [[nodiscard]] const nlohmann::json& hello() const { return hello_; }

  void on_notification(Listener listener) { listener_ = std::move(listener); }

  // Sends a request and waits for its answer. Throws ConnectionError and Interrupted.
  [[nodiscard]] Expected<nlohmann::json, protocol::Failure> call(const std::string& method,
                                                                 const nlohmann::json& parameters,
                                                                 Deadline deadline);

  // Waits on for the answer to the last request, which was not there in time.
  [[nodiscard]] Expected<nlohmann::json, protocol::Failure> wait_on(const std::string& method,
                                                                    Deadline deadline);

  // Feeds notifications to the listener until the deadline. Throws ConnectionError and Interrupted.
  void listen(Deadline deadline);

 private:
  // The next message; nothing when the deadline has passed.
  [[nodiscard]] std::optional<nlohmann::json> receive(Deadline deadline);
  void send(const std::string& line);
  void deliver(const nlohmann::json& message) const;
  void await_greeting(const std::filesystem::path& socket);

  int descriptor_ = -1;
  ClientPurpose purpose_;
  int last_id_ = 0;
  protocol::FrameReader frames_;
  nlohmann::json hello_ = nlohmann::json::object();
  std::optional<std::string> turned_away_;  // why
  Listener listener_;
};

// As protocol::chosen_socket; throws ConnectionError.
[[nodiscard]] std::filesystem::path choose_socket(const std::string& named);

}  // namespace stanok::client
