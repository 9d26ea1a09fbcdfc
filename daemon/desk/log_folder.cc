#include "daemon/desk/log_folder.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using protocol::Failure;
using protocol::FailureKind;

constexpr std::uintmax_t log_bytes_max = 64U << 20;

}  // namespace

Unexpected<Failure> unreadable_log(const std::string& reason) {
  return Unexpected<Failure>(Failure{FailureKind::refused, "E9021", reason, 0, {}});
}

Expected<fs::path, Failure> log_named(const RecordingStatus& status, const std::string& name) {
  const fs::path plain(name);
  if (plain.filename() != plain || plain.extension() != log_ending)
    return unreadable_log(name + ": not the name of a log; history.logs lists the logs");
  return status.log_directory / plain;
}

std::optional<Failure> too_large(const fs::path& log) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(log, error);
  if (error || bytes <= log_bytes_max) return std::nullopt;
  return unreadable_log(log.filename().string() + " has " + std::to_string(bytes >> 20U) +
                        " MiB; the daemon reads logs of up to 64 MiB")
      .value();
}

}  // namespace stanok::daemon
