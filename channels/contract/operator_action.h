// Operator actions by name: "program_hold" <-> OperatorAction::program_hold.
//
// The names connect the operator's command table (protocol/method_table.h) with the input layer of
// the cycle; logs and event files use them too.
#pragma once

#include <optional>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/contract/operator_event.h"

namespace stanok::channels {

[[nodiscard]] std::string_view name_of(OperatorAction action);
[[nodiscard]] std::optional<OperatorAction> operator_action(std::string_view name);

// Whether the action only ever brings motion to rest; such requests are never turned away for want
// of room.
[[nodiscard]] bool is_stop(OperatorAction action) RT_SAFE;

// Whether something may begin to move, or get power, by the action.
[[nodiscard]] bool begins_motion(OperatorAction action) RT_SAFE;

}  // namespace stanok::channels
