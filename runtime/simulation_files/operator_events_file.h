// Operator events for a simulation: JSON lines {"cycle":N,"method":"override.feed","params":{...}}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/simulation.h"

namespace stanok::runtime {

// One event. Throws std::exception with the reason where it is none.
[[nodiscard]] TimedEvent timed_event(std::string_view text);
// In ascending cycles; those of one cycle stay in their order.
void sort_events(std::vector<TimedEvent>& events);

// Events in ascending cycles. Throws std::runtime_error "file:line: reason" on anything that is not
// such an event.
[[nodiscard]] std::vector<TimedEvent> read_operator_events(const std::string& path);

}  // namespace stanok::runtime
