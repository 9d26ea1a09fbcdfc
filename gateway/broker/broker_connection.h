// BrokerConnection: one connection to a broker of MQTT 3.1.1, from its beginning to its end.
//
// It keeps nothing: what was not acknowledged when it ends is the caller's to send again. One
// thread.
#pragma once

#include <mosquitto.h>

#include <chrono>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include "gateway/broker/broker_options.h"

namespace stanok::gateway {

// No broker, or it went away.
class BrokerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class BrokerConnection {
 public:
  // Until step() says so, it is on its way. `will` is published by the broker, retained, when the
  // connection is lost. Throws BrokerError.
  BrokerConnection(const BrokerOptions& options, const std::string& will_topic,
                   const std::string& will);
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
  // An event, QoS 1: the number under which it is acknowledged. Throws BrokerError.
  [[nodiscard]] int publish(const std::string& topic, const std::string& payload);
  // Those that the broker has, since the last call.
  [[nodiscard]] std::set<int> take_acknowledged();

  // Says goodbye: the will is not published.
  void end();

 private:
  static void on_connect(mosquitto* /*unused*/, void* self, int result);
  static void on_publish(mosquitto* /*unused*/, void* self, int number);
  void configure(const BrokerOptions& options, const std::string& will_topic,
                 const std::string& will);

  struct Destroy {
    void operator()(mosquitto* client) const { mosquitto_destroy(client); }
  };
  std::unique_ptr<mosquitto, Destroy> client_;
  bool is_connected_ = false;
  std::string refused_;
  std::chrono::steady_clock::time_point begun_;
  std::set<int> acknowledged_;
};

}  // namespace stanok::gateway
