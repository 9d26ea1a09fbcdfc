// The drives for operators: what the machine file says of them, and how they and their bus are.
#pragma once

#include <nlohmann/json.hpp>

#include "daemon/cycle/running_machine.h"

namespace stanok::daemon {

// The answer to `drive list`: bus, address, kind, requests of one exchange.
[[nodiscard]] nlohmann::json drive_list(const RunningMachine& machine);

// The answer to `drive status`: state, fault, measured values and errors of every drive; exchanges,
// errors by kind and percentiles of the round trip of the bus.
[[nodiscard]] nlohmann::json drive_status(RunningMachine& machine);

}  // namespace stanok::daemon
