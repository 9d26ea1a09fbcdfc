// Operator events for a simulation: JSON lines {"cycle":N,"method":"override.feed","params":{...}}.
#pragma once

#include <string>
#include <vector>

#include "runtime/simulation.h"

namespace stanok::client {

// Events in ascending cycles. Throws std::runtime_error "file:line: reason" on anything that is not
// such an event.
[[nodiscard]] std::vector<runtime::TimedEvent> read_operator_events(const std::string& path);

}  // namespace stanok::client
