// The check events of a log file (messages/log_check_t.lcm), so that no byte of it can change or be
// missing unnoticed: the side that reads. LogWriter makes them.
//
// A check is a message like any other, on a channel of its own: LCM's tools read and play such a
// log. It begins where the check before it ends and covers every byte up to its own sum, its own
// header included. The last one of a file, its trailer, says that the log is complete; a log
// without is one whose recording was cut, or still goes on. Logs of stanok 0.1.0 have no checks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "recording/log/log_reader.h"

namespace stanok::recording {

inline constexpr std::size_t check_sum_bytes = 4;  // at the end of a check event

// CRC-32 as of zlib, of bytes in several parts; 0 of none.
[[nodiscard]] std::uint32_t check_sum(std::uint32_t of_parts_before,
                                      std::span<const std::uint8_t> part);

// The header of an event as it stands in the file.
[[nodiscard]] std::array<std::uint8_t, event_header_bytes> event_header(std::int64_t number,
                                                                        std::int64_t utime,
                                                                        std::size_t channel_bytes,
                                                                        std::size_t data_bytes);

// What the checks of a file say of it.
struct LogCoverage {
  bool has_checks = false;
  LogEnd end = LogEnd::goes_on;   // as the last event says, when it is a check
  std::int64_t sound_bytes = 0;   // from the begin of the file, up to the first fault or last check
  std::int64_t bytes_behind = 0;  // behind the last check
  std::vector<Damage> faults;     // parts that are not as they were written

  // It has a trailer and every byte is as it was written.
  [[nodiscard]] bool is_complete() const { return end != LogEnd::goes_on && faults.empty(); }
};

class CheckReading {
 public:
  // Events in the order of the file.
  void take(const LogEvent& event);
  [[nodiscard]] LogCoverage coverage(std::int64_t bytes_of_file) const;
  // So far: up to where all is as it was written; whether there was a check.
  [[nodiscard]] std::int64_t sound_bytes() const { return coverage_.sound_bytes; }
  [[nodiscard]] bool has_checks() const { return coverage_.has_checks; }
  [[nodiscard]] bool has_faults() const { return !coverage_.faults.empty(); }

 private:
  void compare(const LogEvent& event);

  LogCoverage coverage_;
  // What the next check must say; nothing behind one that cannot be believed.
  struct Next {
    std::int64_t begin = 0;
    std::int64_t seq = 0;
  };
  std::optional<Next> next_ = Next{};
  std::int64_t begin_ = 0;  // in this file, of what the next check covers
  std::uint32_t sum_ = 0;   // of the events since then
};

}  // namespace stanok::recording
