// A request of the operator's command table as the event that enters the cycle, for a daemon and
// for the event file of a simulation alike.
#pragma once

#include <optional>

#include "channels/contract/operator_event.h"
#include "protocol/contract/machine_request.h"

namespace stanok::runtime {

// Of the channel that the request names, 0 where it names none. Nothing: the machine has no such
// action, or not the choice.
[[nodiscard]] std::optional<channels::OperatorEvent> operator_event(
    const protocol::MachineRequest& request);

}  // namespace stanok::runtime
