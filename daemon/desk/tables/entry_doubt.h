// EntryDoubt: why a value that a person gives for the tables wants to be confirmed, in words;
// empty: it is taken at once.
//
// A value is held against [entry_limits] of the machine file (channels/contract/entry_bounds.h) and
// against what the table says now. What does not exist is the cycle's to refuse. Any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "channels/contract/operator_event.h"
#include "daemon/cycle/running_machine.h"
#include "protocol/contract/failure.h"

namespace stanok::daemon {

// What the tables have at the place of a ToolSet or OffsetSet; an offset that they do not name is
// 0. Nothing: there is no such tool or edge.
[[nodiscard]] std::optional<double> value_at(const channels::TablesConfig& tables,
                                             const channels::OperatorCommand& place);

// "tool 3, length: 99999 mm is more than 500 mm (tool_length_max)", of a ToolSet or OffsetSet.
[[nodiscard]] std::string doubt_of_value(const channels::MachineConfig& machine,
                                         const channels::OperatorCommand& command);
// The same, and of a change by more than change_max.
[[nodiscard]] std::string doubt_of_entry(const channels::MachineConfig& machine,
                                         const channels::TablesConfig& now,
                                         const channels::OperatorCommand& command);

// E6095 where a command sets a value that wants to be confirmed and is not.
[[nodiscard]] std::optional<protocol::Failure> obstacle_to_entry(
    RunningMachine& machine, const channels::OperatorEvent& event,
    const nlohmann::json& parameters);

}  // namespace stanok::daemon
