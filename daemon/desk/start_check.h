// Whether a start behind a block search means the approach that was shown.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "daemon/cycle/running_machine.h"
#include "protocol/failure.h"

namespace stanok::daemon {

// Why `program.start` with these parameters is refused; nothing: no search waits for the start, or
// it is the one whose number is given, nothing has changed since, and what the start changes in the
// spindle was asked for.
[[nodiscard]] std::optional<protocol::Failure> obstacle_to_start(RunningMachine& machine,
                                                                 int channel,
                                                                 const nlohmann::json& parameters);

}  // namespace stanok::daemon
