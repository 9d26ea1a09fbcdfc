#include "daemon/desk/operator_command.h"

#include <algorithm>

#include "protocol/contract/machine_request.h"
#include "runtime/operator_request.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

Unexpected<Failure> not_admitted(FailureKind kind, const char* code, std::string text,
                                 int channel = 0) {
  return Unexpected<Failure>(Failure{kind, code, std::move(text), channel, {}});
}

bool has_channel(const config::MachineFile& file, int id) {
  return std::ranges::any_of(file.machine.channels,
                             [&](const auto& channel) { return channel.id == id; });
}

// Commands that make sense for the machine as a whole name no channel.
bool concerns_machine(const protocol::Method& method) {
  return protocol::noun(method) == "machine";
}

}  // namespace

Expected<json, Failure> admitted_parameters(const config::MachineFile& file, protocol::Role role,
                                            const protocol::Method* method,
                                            const protocol::RpcRequest& request) {
  if (method == nullptr) {
    return not_admitted(FailureKind::method_not_found, "E9002",
                        "there is no method \"" + request.method + "\"");
  }
  if (role < method->role) {
    return not_admitted(FailureKind::not_permitted, "E9004",
                        request.method + " needs the role " +
                            std::string(protocol::role_name(method->role)) + "; this session is " +
                            std::string(protocol::role_name(role)));
  }
  auto parameters = protocol::checked_parameters(*method, request.parameters);
  if (!parameters) return parameters;
  const int channel = parameters->value("channel", 0);
  if (channel != 0 && !has_channel(file, channel)) {
    return not_admitted(FailureKind::refused, "E6001",
                        "there is no channel " + std::to_string(channel), channel);
  }
  return parameters;
}

Expected<channels::OperatorEvent, Failure> operator_event(const config::MachineFile& file,
                                                          const protocol::Method& method,
                                                          const json& parameters) {
  auto event = runtime::operator_event(protocol::machine_request(method, parameters));
  if (!event)
    return not_admitted(FailureKind::internal, "", "no action " + std::string(method.action));
  event->situation = parameters.value("situation", std::uint32_t{0});
  event->channel = concerns_machine(method) ? 0 : channel_or_first(file, parameters);
  return *event;
}

int channel_or_first(const config::MachineFile& file, const json& parameters) {
  return parameters.value("channel", file.machine.channels.front().id);
}

}  // namespace stanok::daemon
