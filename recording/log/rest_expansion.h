// RestExpansion: makes the messages again that RestFilter left out of a log.
//
// A record whose streams do not fit what was read, as behind a damaged place, gives nothing for
// these: they count as missing. LogReader has one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "recording/log/rest_pattern.h"

namespace stanok::recording {

class RestExpansion {
 public:
  // An event of the log, in the order of the file.
  void take(std::string_view channel, std::span<const std::uint8_t> bytes);

  struct Repeated {
    std::int64_t utime = 0;
    std::string_view channel;
    std::span<const std::uint8_t> bytes;
  };
  // The next message of the record that was taken last, valid until the next call; nothing: there
  // is no more.
  [[nodiscard]] std::optional<Repeated> next();

 private:
  void begin(std::span<const std::uint8_t> record);

  LatestMessages latest_;
  RestPattern pattern_;
  std::int64_t cycle_ = 0;        // that is being made
  std::int64_t last_cycle_ = -1;  // of the stretch
  std::int64_t utime_ = 0;        // of `cycle_`
  std::int64_t cycle_us_ = 0;
  std::vector<std::size_t> due_;  // in this cycle
  std::size_t next_due_ = 0;
  bool may_continue_ = false;
};

}  // namespace stanok::recording
