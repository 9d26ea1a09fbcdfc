// BrokerConnection: one connection to a broker of MQTT 3.1.1, from its beginning to its end.
//
// It keeps nothing: what was not acknowledged when it ends is the caller's to send again. One
// thread.
#pragma once

#include <mosquitto.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "gateway/broker/broker_options.h"

namespace stanok::gateway {

// No broker, or it went away.
class BrokerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What the broker publishes when the connection is lost.
struct Will {
  enum class Keeping : std::uint8_t { none, retained };
  std::string topic;
  std::string payload;
  Keeping keeping = Keeping::retained;
};

class BrokerConnection {
 public:
  // Until step() says so, it is on its way. Throws BrokerError.
  BrokerConnection(const BrokerOptions& options, const Will& will);
  ~BrokerConnection();
  BrokerConnection(const BrokerConnection&) = delete;
  BrokerConnection& operator=(const BrokerConnection&) = delete;

  // Reads and writes what there is, waiting that long at most. Throws BrokerError.
  void step(std::chrono::milliseconds patience);
  [[nodiscard]] bool is_connected() const { return is_connected_; }
  // Whether what was published has left for the network.
  [[nodiscard]] bool has_sent_all() const;

  // A state. Throws BrokerError.
  void publish_retained(const std::string& topic, const std::string& payload);
  // What is of use now or never, QoS 0, not retained. Throws BrokerError.
  void publish_once(const std::string& topic, const std::string& payload);
  // An event, QoS 1: the number under which it is acknowledged. Throws BrokerError.
  [[nodiscard]] int publish(const std::string& topic, const std::string& payload);
  // Those that the broker has, since the last call.
  [[nodiscard]] std::set<int> take_acknowledged();

  // Throws BrokerError.
  void subscribe(const std::string& topic);
  // What came on topics that were subscribed to, since the last call; the newest of very many.
  [[nodiscard]] std::vector<std::string> take_messages();
  // Says goodbye: the will is not published.
  void end();

 private:
  static void on_connect(mosquitto* /*unused*/, void* self, int result);
  static void on_publish(mosquitto* /*unused*/, void* self, int number);
  static void on_message(mosquitto* /*unused*/, void* self, const mosquitto_message* message);
  void configure(const BrokerOptions& options, const Will& will);

  struct Destroy {
    void operator()(mosquitto* client) const { mosquitto_destroy(client); }
  };
  std::unique_ptr<mosquitto, Destroy> client_;
  bool is_connected_ = false;
  std::string refused_;
  std::chrono::steady_clock::time_point begun_;
  std::set<int> acknowledged_;
  std::vector<std::string> messages_;
};

}  // namespace stanok::gateway
