// Plays a log: its messages once more on the bus, at the pace at which they were recorded or at
// another.
#pragma once

#include <filesystem>
#include <functional>

#include "base/expected.h"
#include "recording/log/log_reader.h"
#include "recording/stream/message_sink.h"

namespace stanok::recording {

struct PlayResult {
  std::int64_t messages = 0;
  double recorded_s = 0.0;     // from the first message to the last one
  std::vector<Damage> damage;  // what was left out
};

// `speed` 1 is the recorded pace, 0 as fast as it goes. `interrupted` is asked before every
// message.
[[nodiscard]] Expected<PlayResult, LogError> play(const std::filesystem::path& file, double speed,
                                                  MessageSink& sink,
                                                  const std::function<bool()>& interrupted);

}  // namespace stanok::recording
