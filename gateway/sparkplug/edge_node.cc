#include "gateway/sparkplug/edge_node.h"

#include <stanok_protobuf/sparkplug_b.pb.h>

#include <utility>

#include "protocol/contract/json_text.h"

namespace stanok::gateway {
namespace {

using nlohmann::json;
using sparkplug::Payload;

constexpr const char* session_metric = "bdSeq";
constexpr const char* rebirth_metric = "Node Control/Rebirth";
constexpr std::uint64_t numbers = 256;

std::string bytes_of(const Payload& payload) {
  return payload.SerializeAsString();
}

}  // namespace

EdgeNode::EdgeNode(std::string group, std::string node, std::uint64_t session)
    : group_(std::move(group)), node_(std::move(node)), session_(session % numbers) {}

SparkplugMessage EdgeNode::death(std::int64_t time_ms) const {
  Payload payload;
  payload.set_timestamp(static_cast<std::uint64_t>(time_ms));
  Payload::Metric& session = *payload.add_metrics();
  session.set_name(session_metric);
  session.set_datatype(static_cast<std::uint32_t>(DataType::uint64));
  session.set_long_value(session_);
  return {topic_of("NDEATH", ""), bytes_of(payload)};
}

std::vector<SparkplugMessage> EdgeNode::births(std::int64_t time_ms) {
  number_ = 0;
  Payload payload;
  payload.set_timestamp(static_cast<std::uint64_t>(time_ms));
  payload.set_seq(next_number());
  Payload::Metric& session = *payload.add_metrics();
  session.set_name(session_metric);
  session.set_timestamp(static_cast<std::uint64_t>(time_ms));
  session.set_datatype(static_cast<std::uint32_t>(DataType::uint64));
  session.set_long_value(session_);
  Payload::Metric& rebirth = *payload.add_metrics();
  rebirth.set_name(rebirth_metric);
  rebirth.set_timestamp(static_cast<std::uint64_t>(time_ms));
  rebirth.set_datatype(static_cast<std::uint32_t>(DataType::boolean));
  rebirth.set_boolean_value(false);
  std::vector<SparkplugMessage> messages{{topic_of("NBIRTH", ""), bytes_of(payload)}};
  for (const auto& [machine, device] : devices_)
    if (device.is_born) messages.push_back(birth_of(machine, time_ms));
  return messages;
}

std::vector<SparkplugMessage> EdgeNode::update(
    const std::map<std::string, StatesOfMachine>& machines, std::int64_t time_ms) {
  std::vector<SparkplugMessage> messages;
  for (const auto& [machine, states] : machines) {
    Device& device = devices_[machine];
    const auto state = states.find("state");
    const bool is_connected = state != states.end() && state->second.value("connected", false);
    if (!is_connected) {
      if (device.is_born) messages.push_back(of_device(machine, "DDEATH", {}, time_ms));
      device.is_born = false;
      continue;
    }
    Metrics now;
    for (const auto& [name, content] : states) flatten(name, content, now);
    const Change change = take(device, now);
    if (!device.is_born || change.needs_birth) {
      device.is_born = true;
      messages.push_back(birth_of(machine, time_ms));
    } else if (!change.names.empty()) {
      messages.push_back(of_device(machine, "DDATA", change.names, time_ms));
    }
  }
  return messages;
}

void EdgeNode::flatten(const std::string& name, const json& value, Metrics& metrics) {
  if (value.is_object()) {
    for (const auto& [member, content] : value.items())
      flatten(std::string(name).append("/").append(member), content, metrics);
  } else if (value.is_number()) {
    metrics[name] = {DataType::real, value.get<double>()};
  } else if (value.is_boolean()) {
    metrics[name] = {DataType::boolean, value};
  } else if (value.is_array()) {
    metrics[name] = {DataType::text, protocol::json_text(value)};
  } else {
    metrics[name] = {DataType::text, value};
  }
}

EdgeNode::Change EdgeNode::take(Device& device, const Metrics& now) {
  Change change;
  for (const auto& [name, metric] : now) {
    const auto [known, is_new] = device.metrics.emplace(name, metric);
    change.needs_birth = change.needs_birth || is_new;
    if (is_new || known->second.value == metric.value) continue;
    if (!metric.value.is_null() && known->second.type != metric.type) {
      known->second.type = metric.type;
      change.needs_birth = true;
    }
    known->second.value = metric.value;
    change.names.push_back(name);
  }
  for (auto& [name, metric] : device.metrics) {
    if (now.contains(name) || metric.value.is_null()) continue;
    metric.value = nullptr;
    change.names.push_back(name);
  }
  return change;
}

SparkplugMessage EdgeNode::birth_of(const std::string& machine, std::int64_t time_ms) {
  std::vector<std::string> names;
  for (const auto& [name, metric] : devices_.at(machine).metrics) names.push_back(name);
  return of_device(machine, "DBIRTH", names, time_ms);
}

SparkplugMessage EdgeNode::of_device(const std::string& machine, const char* kind,
                                     const std::vector<std::string>& names, std::int64_t time_ms) {
  Payload payload;
  payload.set_timestamp(static_cast<std::uint64_t>(time_ms));
  payload.set_seq(next_number());
  for (const std::string& name : names) {
    const Metric& metric = devices_.at(machine).metrics.at(name);
    Payload::Metric& told = *payload.add_metrics();
    told.set_name(name);
    told.set_timestamp(static_cast<std::uint64_t>(time_ms));
    told.set_datatype(static_cast<std::uint32_t>(metric.type));
    if (metric.value.is_null()) {
      told.set_is_null(true);
    } else if (metric.type == DataType::real) {
      told.set_double_value(metric.value.get<double>());
    } else if (metric.type == DataType::boolean) {
      told.set_boolean_value(metric.value.get<bool>());
    } else {
      told.set_string_value(metric.value.get<std::string>());
    }
  }
  return {topic_of(kind, machine), bytes_of(payload)};
}

std::string EdgeNode::command_topic() const {
  return topic_of("NCMD", "");
}

bool EdgeNode::asks_for_births(std::string_view payload) {
  Payload command;
  if (!command.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return false;
  for (const Payload::Metric& metric : command.metrics())
    if (metric.name() == rebirth_metric && metric.boolean_value()) return true;
  return false;
}

std::string EdgeNode::topic_of(const char* kind, const std::string& machine) const {
  const std::string topic = "spBv1.0/" + group_ + "/" + kind + "/" + node_;
  return machine.empty() ? topic : topic + "/" + machine;
}

std::uint64_t EdgeNode::next_number() {
  const std::uint64_t number = number_;
  number_ = (number_ + 1) % numbers;
  return number;
}

}  // namespace stanok::gateway
