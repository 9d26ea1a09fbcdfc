// LogSwitch: a log that is begun and ended while the stream of messages goes on. What is begun late
// starts with the prologue, so that it can be read alone. One thread.
#pragma once

#include <memory>

#include "recording/log/log_writer.h"
#include "recording/stream/prologue.h"

namespace stanok::recording {

class LogSwitch final : public MessageSink {
 public:
  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override {
    prologue_.take(channel, bytes);
    if (writer_) writer_->send(channel, utime, bytes);
  }

  // From now on to `writer`; nullptr: nowhere. The log before is complete then.
  void turn_to(std::unique_ptr<LogWriter> writer, std::int64_t utime) {
    writer_ = std::move(writer);
    if (writer_) prologue_.send_to(*writer_, utime);
  }

  [[nodiscard]] LogWriter* writer() { return writer_.get(); }  // nullptr: no log is written

 private:
  Prologue prologue_;
  std::unique_ptr<LogWriter> writer_;
};

}  // namespace stanok::recording
