// The setpoints of one channel of a log as CSV: a heading, then one row per cycle.
//
// Numbers are written so that reading them gives the same bits. Columns of the axes carry their
// machine names and units; those of the programmed point the words of the program.
#pragma once

#include <cstdint>
#include <cstdio>

#include "base/expected.h"
#include "recording/read/log_contents.h"

namespace stanok::recording {

// Returns the number of rows. `contents` are those of the same file; `channel` is one of its
// setpoint channels.
[[nodiscard]] Expected<std::int64_t, LogError> export_setpoints(const std::filesystem::path& file,
                                                                const LogContents& contents,
                                                                int channel, std::FILE* csv);

}  // namespace stanok::recording
