// LogSwitch: a log that is begun and ended while the stream of messages goes on. What is begun late
// starts with the prologue, so that it can be read alone. What a machine at rest says again and
// again is left out (rest_filter.h). One thread.
#pragma once

#include <memory>
#include <optional>

#include "recording/log/log_writer.h"
#include "recording/log/rest_filter.h"
#include "recording/stream/prologue.h"

namespace stanok::recording {

class LogSwitch final : public MessageSink {
 public:
  LogSwitch() = default;
  ~LogSwitch() override { static_cast<void>(finish()); }
  LogSwitch(const LogSwitch&) = delete;
  LogSwitch& operator=(const LogSwitch&) = delete;

  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override {
    prologue_.take(channel, bytes);
    if (rest_) rest_->send(channel, utime, bytes);
  }

  // From now on to `writer`; nullptr: nowhere. The log before is complete then.
  void turn_to(std::unique_ptr<LogWriter> writer, std::int64_t utime) {
    static_cast<void>(finish());
    writer_ = std::move(writer);
    if (!writer_) return;
    rest_.emplace(*writer_);
    prologue_.send_to(*rest_, utime);
  }
  // The log is complete; what is sent behind it is ignored. False: see its status.
  bool finish() {
    if (!writer_) return true;
    if (rest_) rest_->finish();
    rest_.reset();
    return writer_->finish();
  }

  [[nodiscard]] LogWriter* writer() { return writer_.get(); }  // nullptr: no log is written

 private:
  Prologue prologue_;
  std::unique_ptr<LogWriter> writer_;
  std::optional<RestFilter> rest_;  // before that writer; nothing: the log is complete
};

}  // namespace stanok::recording
