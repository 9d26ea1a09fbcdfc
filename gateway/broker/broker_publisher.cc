#include "gateway/broker/broker_publisher.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "gateway/cell/topics.h"
#include "gateway/outbox/backoff.h"
#include "gateway/outbox/wall_clock.h"

namespace stanok::gateway {
namespace {

using namespace std::chrono_literals;

constexpr auto step_time = 20ms;
constexpr std::size_t under_way_max = 64;

}  // namespace

BrokerPublisher::BrokerPublisher(BrokerOptions options, std::string prefix,
                                 std::filesystem::path outbox, StateBoard& board)
    : options_(std::move(options)),
      prefix_(std::move(prefix)),
      outbox_file_(std::move(outbox)),
      board_(board),
      settled_(options_.resent) {}

void BrokerPublisher::run(const std::stop_token& stop) {
  Backoff backoff;
  while (!stop.stop_requested()) {
    was_connected_ = false;
    try {
      Outbox outbox(outbox_file_);
      serve(stop, outbox);
    } catch (const std::exception& error) {
      if (was_connected_) backoff.reset();
      if (backoff.is_first() || was_connected_)
        spdlog::warn("broker {}:{}: {}; trying again", options_.host, options_.port, error.what());
      backoff.wait(stop);
    }
  }
}

void BrokerPublisher::serve(const std::stop_token& stop, Outbox& outbox) {
  const std::string own_topic(topic_of(prefix_, "", topic::gateway));
  BrokerConnection connection(options_, {own_topic, online("no"), Will::Keeping::retained});
  under_way_.clear();
  settled_.clear();
  sent_ = outbox.position(consumer);
  while (!stop.stop_requested()) {
    connection.step(step_time);
    if (!connection.is_connected()) continue;
    if (!was_connected_) {
      was_connected_ = true;
      spdlog::info("broker {}:{}: connected", options_.host, options_.port);
      connection.publish_retained(own_topic, online("yes"));
      board_.renew_all();
    }
    note_acknowledged(connection, outbox);
    send_events(connection, outbox);
    send_states(connection);
  }
  if (!connection.is_connected()) return;
  connection.publish_retained(own_topic, online("no"));
  connection.end();
}

void BrokerPublisher::send_states(BrokerConnection& connection) {
  if (!connection.has_sent_all()) return;
  for (const auto& [topic, payload] : board_.take_new())
    connection.publish_retained(topic, payload);
}

void BrokerPublisher::send_events(BrokerConnection& connection, Outbox& outbox) {
  if (under_way_.size() >= under_way_max) return;
  const auto room = static_cast<std::int64_t>(under_way_max - under_way_.size());
  for (StoredEvent& stored : outbox.behind(sent_, room)) {
    Event& event = stored.event;
    const std::string payload =
        board_.payload(stored.number, event.time_s, std::move(event.content));
    under_way_[stored.number] =
        connection.publish(event_topic_of(prefix_, event.machine, event.kind), payload);
    sent_ = stored.number;
  }
}

// The position is behind the last one before which all were acknowledged long enough ago.
void BrokerPublisher::note_acknowledged(BrokerConnection& connection, Outbox& outbox) {
  const auto now = SettledPosition::Clock::now();
  const std::set<int> acknowledged = connection.take_acknowledged();
  if (!acknowledged.empty()) {
    std::erase_if(under_way_, [&](const auto& one) { return acknowledged.contains(one.second); });
    settled_.acknowledge(under_way_.empty() ? sent_ : under_way_.begin()->first - 1, now);
  }
  if (const auto number = settled_.take(now)) outbox.set_position(consumer, *number);
}

std::string BrokerPublisher::online(const char* word) const {
  return board_.payload(0, wall_clock_s(), {{"online", std::string(word) == "yes"}});
}

}  // namespace stanok::gateway
