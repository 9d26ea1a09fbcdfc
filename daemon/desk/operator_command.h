// A request of the command table, checked, and as the event that enters the cycle.
//
// The way of all commands, whether the operator server or the reception takes them: the table
// (protocol/contract/method_table.h) is the one place where they are defined. Any thread.
#pragma once

#include <nlohmann/json.hpp>

#include "base/expected.h"
#include "channels/contract/operator_event.h"
#include "config/files/machine_file.h"
#include "protocol/contract/json_rpc.h"

namespace stanok::daemon {

// The checked parameters, if the role may call the method and the channel exists.
[[nodiscard]] Expected<nlohmann::json, protocol::Failure> admitted_parameters(
    const config::MachineFile& file, protocol::Role role, const protocol::Method* method,
    const protocol::RpcRequest& request);

// The method has an action.
[[nodiscard]] Expected<channels::OperatorEvent, protocol::Failure> operator_event(
    const config::MachineFile& file, const protocol::Method& method,
    const nlohmann::json& parameters);

// The channel that the parameters name, or the first one of the machine.
[[nodiscard]] int channel_or_first(const config::MachineFile& file,
                                   const nlohmann::json& parameters);

}  // namespace stanok::daemon
