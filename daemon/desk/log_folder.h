// Logs that clients name: those of the folder in which the daemon writes them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/expected.h"
#include "daemon/cycle/running_machine.h"
#include "protocol/contract/failure.h"

namespace stanok::daemon {

inline constexpr auto* log_ending = ".lcm";

[[nodiscard]] Unexpected<protocol::Failure> unreadable_log(const std::string& reason);

// A name in the folder of the logs; nothing else has one.
[[nodiscard]] Expected<std::filesystem::path, protocol::Failure> log_named(
    const RecordingStatus& status, const std::string& name);

// What is made of a log takes a few times its memory, and the machine beside it must not want for
// any; nothing: it is small enough.
[[nodiscard]] std::optional<protocol::Failure> too_large(const std::filesystem::path& log);

}  // namespace stanok::daemon
