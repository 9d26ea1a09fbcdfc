// All setpoints of one channel of a log, in the order of the file.
#pragma once

#include <functional>
#include <optional>

#include "recording/format/decode.h"
#include "recording/read/log_contents.h"

namespace stanok::recording {

// Calls `visit` for each; skips what cannot be decoded. Nothing is returned but the reason why the
// file cannot be read.
[[nodiscard]] std::optional<LogError> for_each_setpoint(
    const std::filesystem::path& file, const LogContents& contents, int channel,
    const std::function<void(const setpoint_t&)>& visit);

}  // namespace stanok::recording
