#include "gateway/sparkplug/sparkplug_publisher.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "gateway/broker/broker_connection.h"
#include "gateway/outbox/backoff.h"
#include "gateway/outbox/wall_clock.h"

namespace stanok::gateway {
namespace {

using namespace std::chrono_literals;

constexpr auto step_time = 20ms;

std::int64_t now_ms() {
  constexpr double ms_per_s = 1e3;
  return std::llround(wall_clock_s() * ms_per_s);
}

void send(BrokerConnection& connection, const std::vector<SparkplugMessage>& messages) {
  for (const SparkplugMessage& message : messages)
    connection.publish_once(message.topic, message.payload);
}

// The states of PREFIX/MACHINE/NAME by machine and name.
std::map<std::string, StatesOfMachine> by_machine(const std::string& prefix,
                                                  const StateBoard::Contents& contents) {
  std::map<std::string, StatesOfMachine> machines;
  for (const auto& [topic, content] : contents) {
    const std::size_t begin = prefix.size() + 1;
    const std::size_t slash = topic.find('/', begin);
    if (slash == std::string::npos) continue;
    machines[topic.substr(begin, slash - begin)][topic.substr(slash + 1)] = content;
  }
  return machines;
}

}  // namespace

SparkplugPublisher::SparkplugPublisher(BrokerOptions options, std::string prefix, std::string group,
                                       const std::filesystem::path& outbox, StateBoard& board)
    : options_(std::move(options)),
      prefix_(std::move(prefix)),
      group_(std::move(group)),
      node_("stanok-" + board.source()),
      board_(board),
      outbox_(outbox) {}

void SparkplugPublisher::run(const std::stop_token& stop) {
  Backoff backoff;
  while (!stop.stop_requested()) {
    was_connected_ = false;
    try {
      serve(stop);
    } catch (const std::exception& error) {
      if (was_connected_) backoff.reset();
      if (backoff.is_first() || was_connected_)
        spdlog::warn("Sparkplug at {}:{}: {}; trying again", options_.host, options_.port,
                     error.what());
      backoff.wait(stop);
    }
  }
}

void SparkplugPublisher::serve(const std::stop_token& stop) {
  EdgeNode node(group_, node_, outbox_.sparkplug_session());
  const SparkplugMessage will = node.death(now_ms());
  BrokerConnection connection(options_, {will.topic, will.payload, Will::Keeping::none});
  told_ = -1;
  while (!stop.stop_requested()) {
    connection.step(step_time);
    if (!connection.is_connected()) continue;
    if (!was_connected_) {
      was_connected_ = true;
      outbox_.note_sparkplug_session();
      spdlog::info("Sparkplug at {}:{}: connected as {}/{}", options_.host, options_.port, group_,
                   node_);
      connection.subscribe(node.command_topic());
      send(connection, node.births(now_ms()));
    }
    for (const std::string& command : connection.take_messages())
      if (EdgeNode::asks_for_births(command)) send(connection, node.births(now_ms()));
    tell_news(connection, node);
  }
  if (!connection.is_connected()) return;
  send(connection, {node.death(now_ms())});
  connection.end();
}

void SparkplugPublisher::tell_news(BrokerConnection& connection, EdgeNode& node) {
  if (!connection.has_sent_all()) return;
  if (const auto contents = board_.contents_since(told_))
    send(connection, node.update(by_machine(prefix_, *contents), now_ms()));
}

}  // namespace stanok::gateway
