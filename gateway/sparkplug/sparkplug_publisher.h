// SparkplugPublisher: the states of the board to hosts of Sparkplug B, in a thread of its own and
// on a connection of its own, whose will is the death of the node.
//
// A host may ask for births; nothing else that it sends is looked at. Events stay with the topics
// of gateway/broker, which lose none: data of Sparkplug is sent once.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "gateway/broker/broker_options.h"
#include "gateway/cell/state_board.h"
#include "gateway/outbox/outbox.h"
#include "gateway/sparkplug/edge_node.h"

namespace stanok::gateway {

class BrokerConnection;

class SparkplugPublisher {
 public:
  // `prefix`: of the topics of the board, which name the machines.
  // `outbox` keeps the number of the next session over a start. Throws DatabaseError.
  SparkplugPublisher(BrokerOptions options, std::string prefix, std::string group,
                     const std::filesystem::path& outbox, StateBoard& board);

  // Until it is asked to stop.
  void run(const std::stop_token& stop);

 private:
  // One connection, from its beginning to its end.
  void serve(const std::stop_token& stop);
  void tell_news(BrokerConnection& connection, EdgeNode& node);

  BrokerOptions options_;
  std::string prefix_;
  std::string group_;
  std::string node_;
  StateBoard& board_;
  Outbox outbox_;
  bool was_connected_ = false;
  std::int64_t told_ = -1;  // number of the newest state that was told
};

}  // namespace stanok::gateway
