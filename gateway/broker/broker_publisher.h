// BrokerPublisher: states of the board and events of the outbox to the broker, in a thread of its
// own.
//
// States are sent when they are new and nothing else waits for the network: a slow broker gets
// fewer of them. Events are sent in their order, some of them at once, until the broker has
// acknowledged them. What is not acknowledged when the connection ends, or was only shortly before,
// is sent again on the next one, with the same number.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stop_token>
#include <string>

#include "gateway/broker/broker_connection.h"
#include "gateway/broker/broker_options.h"
#include "gateway/broker/settled_position.h"
#include "gateway/cell/state_board.h"
#include "gateway/outbox/outbox.h"

namespace stanok::gateway {

class BrokerPublisher {
 public:
  static constexpr const char* consumer = "broker";

  BrokerPublisher(BrokerOptions options, std::string prefix, std::filesystem::path outbox,
                  StateBoard& board);

  // Until it is asked to stop.
  void run(const std::stop_token& stop);

 private:
  // One connection, from its beginning to its end.
  void serve(const std::stop_token& stop, Outbox& outbox);
  void send_states(BrokerConnection& connection);
  void send_events(BrokerConnection& connection, Outbox& outbox);
  void note_acknowledged(BrokerConnection& connection, Outbox& outbox);
  [[nodiscard]] std::string online(const char* word) const;

  BrokerOptions options_;
  std::string prefix_;
  std::filesystem::path outbox_file_;
  StateBoard& board_;
  bool was_connected_ = false;
  std::int64_t sent_ = 0;                  // up to this number
  std::map<std::int64_t, int> under_way_;  // by number of the outbox; of the connection
  SettledPosition settled_;
};

}  // namespace stanok::gateway
