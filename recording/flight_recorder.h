// FlightRecorder: the messages of the last seconds in memory, to be written when something went
// wrong.
//
// Whole seconds are dropped from the old end, so that between `span` and one second more is kept.
// A file of it begins with the prologue and can be read, plotted and exported as any log; to verify
// a run its beginning is needed, which is not there. One thread.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/expected.h"
#include "recording/log_writer.h"
#include "recording/message_sink.h"
#include "recording/prologue.h"

namespace stanok::recording {

class FlightRecorder final : public MessageSink {
 public:
  explicit FlightRecorder(std::int64_t span_us) : span_us_(span_us) {}

  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override;

  // Number of messages written.
  [[nodiscard]] Expected<std::int64_t, LogError> write(const std::filesystem::path& file) const;

  [[nodiscard]] std::size_t bytes() const;  // of the messages at hand

 private:
  struct Entry {
    std::size_t channel = 0;  // index in channels_
    std::int64_t utime = 0;
    std::size_t end = 0;  // of its bytes; they begin where those of the entry before end
  };
  struct Second {
    std::int64_t begin_us = 0;
    std::vector<Entry> entries;
    std::vector<std::uint8_t> bytes;
  };

  [[nodiscard]] std::size_t index_of(const std::string& channel);
  void begin_second(std::int64_t utime);

  std::int64_t span_us_;
  Prologue prologue_;
  std::vector<std::string> channels_;
  std::deque<Second> seconds_;
};

}  // namespace stanok::recording
