// Why a table of a log could not be written.
#pragma once

#include <filesystem>

#include "jobs/npz/npz_file.h"
#include "recording/log/log_writer.h"

namespace stanok::jobs {

[[nodiscard]] inline Unexpected<recording::LogError> not_written(const NpzError& error) {
  return Unexpected<recording::LogError>({error.system_error, error.text});
}

// Fewer rows than there were.
[[nodiscard]] inline Unexpected<recording::LogError> has_changed(const std::filesystem::path& log) {
  return Unexpected<recording::LogError>({0, log.string() + " has changed while it was read"});
}

}  // namespace stanok::jobs
