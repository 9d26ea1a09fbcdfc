// Where encoded messages go: a log file, the LCM bus, a memory of the last seconds.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace stanok::recording {

class MessageSink {
 public:
  virtual ~MessageSink() = default;

  // Takes one message of the named LCM channel; `bytes` are valid during the call only. A sink that
  // cannot take it says so in its own status: recording never stops the machine.
  virtual void send(const std::string& channel, std::int64_t utime,
                    std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace stanok::recording
