// SituationWalk: what gave the words of the channels their meaning, in the order of the file. A log
// tells a situation every second again; the walk tells it where another one comes into effect.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stanok_messages/situation_t.hpp>

#include "recording/log/log_reader.h"

namespace stanok::recording {

class SituationWalk {
 public:
  // `channel` 0: of all channels.
  [[nodiscard]] static Expected<SituationWalk, LogError> open(const std::filesystem::path& file,
                                                              int channel);

  // The next one; nothing at the end of the log.
  [[nodiscard]] std::optional<situation_t> next();

 private:
  SituationWalk(LogReader reader, int channel) : reader_(std::move(reader)), channel_(channel) {}

  LogReader reader_;
  int channel_;
  std::map<std::int32_t, std::int64_t> newest_;  // number by channel
};

}  // namespace stanok::recording
