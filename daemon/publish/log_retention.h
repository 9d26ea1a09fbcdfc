// LogRetention: the bounds that the logs and flight files of one machine keep on the disk: all
// together, by age, and by the space that stays free for others.
//
// What is over a bound goes oldest first, as whole files: pieces of a log one by one, the newest
// flight file last of all. The piece that is being written is never removed; when there is no room
// all the same, whoever writes must rest. Files whose names are not those of this machine are left
// alone. Removing gigabytes takes time: not for the publisher's thread. Any other, one at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/files/machine_file.h"

namespace stanok::daemon {

struct LogLimits {
  std::int64_t bytes_max = 0;            // 0: no bound
  std::chrono::seconds age_max{0};       // 0: no bound
  std::int64_t free_bytes_min = 0;       // 0: nothing is reserved
  std::int64_t piece_bytes_max = 0;      // of one file, so that bytes_max has room for several
  std::int64_t bytes_between_looks = 0;  // that may be written until the next `tidy`
};

[[nodiscard]] LogLimits log_limits_of(const config::RecorderConfig& config);

// Where time and free space come from.
struct LogDisk {
  std::function<std::chrono::system_clock::time_point()> now;
  // Of the disk that has the folder; nothing: it does not say.
  std::function<std::optional<std::int64_t>(const std::filesystem::path&)> free_bytes;
};

[[nodiscard]] LogDisk disk_of_this_computer();

// What is kept, as `tidy` left it.
struct KeptLogs {
  std::int64_t files = 0;
  std::int64_t bytes = 0;
  std::optional<std::int64_t> free_bytes;
  std::string no_room;  // why nothing may be written; empty: there is room
};

class LogRetention {
 public:
  LogRetention(std::filesystem::path directory, std::string machine, const LogLimits& limits,
               LogDisk disk = disk_of_this_computer());

  // Removes what is over the bounds, so that `wanted_bytes` more keep within them. `open`: the
  // first piece of the log that is being written; empty: none is.
  KeptLogs tidy(const std::filesystem::path& open, std::int64_t wanted_bytes = 0);
  // What the latest `tidy` left.
  [[nodiscard]] KeptLogs kept() const;
  [[nodiscard]] const LogLimits& limits() const { return limits_; }

 private:
  struct File;
  [[nodiscard]] std::vector<File> files(const std::filesystem::path& open) const;
  [[nodiscard]] bool is_too_old(const File& file) const;
  [[nodiscard]] bool has_room(const KeptLogs& kept, std::int64_t wanted_bytes) const;
  [[nodiscard]] std::string why_no_room(const KeptLogs& kept, std::int64_t wanted_bytes) const;

  std::filesystem::path directory_;
  std::string machine_;
  LogLimits limits_;
  LogDisk disk_;
  mutable std::mutex mutex_;
  KeptLogs kept_;
  bool rests_ = false;  // nothing was to be written: it goes on with some room more
};

// Of a file in the folder: what the name says; nothing: it is none of this machine's.
struct LogFileName {
  bool is_flight = false;
  std::string log;  // the name without number of its piece and ending
  int piece = 1;
};
[[nodiscard]] std::optional<LogFileName> log_file_name_of(std::string_view file_name,
                                                          std::string_view machine);

}  // namespace stanok::daemon
