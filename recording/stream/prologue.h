// Prologue: the messages without which a piece of a log cannot be read, so that each piece stands
// alone: the latest LOG_META and LOG_TYPES, and every text that was sent and who read it. A copy
// shares them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "recording/stream/message_sink.h"

namespace stanok::recording {

class Prologue {
 public:
  // Keeps the message when it belongs to the prologue.
  void take(const std::string& channel, std::span<const std::uint8_t> bytes);

  // All that was kept, LOG_META first, at the time `utime`.
  void send_to(MessageSink& sink, std::int64_t utime) const;

 private:
  struct Kept {
    std::string channel;
    std::vector<std::uint8_t> bytes;
  };
  std::shared_ptr<const Kept> meta_;
  std::shared_ptr<const Kept> types_;
  std::vector<std::shared_ptr<const Kept>> texts_;
};

}  // namespace stanok::recording
