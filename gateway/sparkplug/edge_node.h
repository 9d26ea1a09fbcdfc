// EdgeNode: the states of machines in the messages of Sparkplug B (Eclipse Sparkplug 3.0.0): the
// gateway is an edge node, each machine a device of it.
//
// A birth names all metrics with their types, data tells those that have changed, a death says that
// node or device is away. Metrics are the members of the states (docs/integrator/cell.md), named by
// their path: numbers are Double, texts String, lists their JSON as String. A metric that a birth
// has not named leads to a new birth; one that is no more is null. Knows no network; one thread.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::gateway {

struct SparkplugMessage {
  std::string topic;
  std::string payload;  // protocol buffer
};

// States of a machine by the names of their topics.
using StatesOfMachine = std::map<std::string, nlohmann::json>;

class EdgeNode {
 public:
  // `group` and `node`: levels of a topic. `session`: counts up from connection to connection; a
  // host tells by it which birth a death belongs to.
  EdgeNode(std::string group, std::string node, std::uint64_t session);

  // The will of the connection, and the last message of one that ends in order.
  [[nodiscard]] SparkplugMessage death(std::int64_t time_ms) const;
  // The node is there, or a host has asked: the births of node and connected machines.
  [[nodiscard]] std::vector<SparkplugMessage> births(std::int64_t time_ms);
  // What has to be said of the newest states, after the first births.
  [[nodiscard]] std::vector<SparkplugMessage> update(
      const std::map<std::string, StatesOfMachine>& machines, std::int64_t time_ms);

  // Where hosts ask for births.
  [[nodiscard]] std::string command_topic() const;
  [[nodiscard]] static bool asks_for_births(std::string_view payload);

 private:
  enum class DataType : std::uint8_t { uint64 = 8, real = 10, boolean = 11, text = 12 };
  struct Metric {
    DataType type = DataType::text;
    nlohmann::json value;  // null: there is none
  };
  using Metrics = std::map<std::string, Metric>;
  struct Device {
    bool is_born = false;
    Metrics metrics;
  };

  static void flatten(const std::string& name, const nlohmann::json& value, Metrics& metrics);
  // Into what is known of the device: the names whose values are new; `all`: one has a new name or
  // another type.
  struct Change {
    std::vector<std::string> names;
    bool needs_birth = false;
  };
  static Change take(Device& device, const Metrics& now);
  [[nodiscard]] SparkplugMessage of_device(const std::string& machine, const char* kind,
                                           const std::vector<std::string>& names,
                                           std::int64_t time_ms);
  [[nodiscard]] SparkplugMessage birth_of(const std::string& machine, std::int64_t time_ms);
  [[nodiscard]] std::string topic_of(const char* kind, const std::string& machine) const;
  [[nodiscard]] std::uint64_t next_number();

  std::string group_;
  std::string node_;
  std::uint64_t session_;
  std::uint64_t number_ = 0;  // of the next message, 0 to 255
  std::map<std::string, Device> devices_;
};

}  // namespace stanok::gateway
