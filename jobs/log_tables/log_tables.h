// Tables of one channel of a log as files: the rows of its process as CSV, and its setpoints or the
// rows of its process as an .npz file for NumPy. One pass over the log, in bounded memory.
//
// Each returns the number of rows. `contents` are those of the same file, which may have grown
// since: what came later is left out.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "base/expected.h"
#include "recording/read/log_contents.h"

namespace stanok::jobs {

using RowsOrError = Expected<std::int64_t, recording::LogError>;

// A heading, then a row per cycle that tells of the process: numbers with the same bits as in the
// log, nothing where a row has no value.
[[nodiscard]] RowsOrError write_process_csv(const std::filesystem::path& log, int channel,
                                            std::FILE* csv);

// An array for each column. The log is read twice: the arrays have a size at their begin.
[[nodiscard]] RowsOrError write_process_npz(const std::filesystem::path& log, int channel,
                                            const std::filesystem::path& npz);

// An array for each field, (n,), or (n, k) of the axes; names, words and units of the axes as
// `axes`, `words` and `units`. `channel` is one of the setpoint channels.
[[nodiscard]] RowsOrError write_setpoints_npz(const std::filesystem::path& log,
                                              const recording::LogContents& contents, int channel,
                                              const std::filesystem::path& npz);

}  // namespace stanok::jobs
