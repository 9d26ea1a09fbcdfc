// FlightRecorder: the messages of the last seconds in memory, to be written when something went
// wrong.
//
// Whole seconds are dropped from the old end, so that between `span` and one second more is kept.
// Their memory comes in chunks that are used again: what is held is what is kept, however unlike
// the seconds of a run are. A file of it begins with the prologue and can be read, plotted and
// exported as any log; to verify a run its beginning is needed, which is not there. One thread;
// what it had at one moment may be written by another one, since that takes longer than the rings
// of the cycle hold.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/expected.h"
#include "recording/log/log_writer.h"
#include "recording/stream/message_sink.h"
#include "recording/stream/prologue.h"

namespace stanok::recording {

// What a flight recorder had at one moment; it shares the messages with the recorder, which does
// not change them any more.
class FlightRecording {
 public:
  // Number of messages written. Any thread.
  [[nodiscard]] Expected<std::int64_t, LogError> write(const std::filesystem::path& file) const;
  // Of such a file, about.
  [[nodiscard]] std::int64_t bytes() const;

 private:
  friend class FlightRecorder;
  using Chunk = std::vector<std::uint8_t>;
  struct Entry {
    std::size_t channel = 0;  // index in channels_
    std::int64_t utime = 0;
    std::size_t chunk = 0;  // that has its bytes
    std::size_t end = 0;    // of them in it; they begin where those of the entry before end
  };
  struct Second {
    std::int64_t begin_us = 0;
    std::vector<Entry> entries;
    std::vector<Chunk> chunks;
  };

  Prologue prologue_;
  std::vector<std::string> channels_;
  std::deque<std::shared_ptr<const Second>> seconds_;
};

class FlightRecorder final : public MessageSink {
 public:
  explicit FlightRecorder(std::int64_t span_us) : span_us_(span_us) {}

  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override;

  // Copies no messages: quick, however much there is.
  [[nodiscard]] FlightRecording recording();

  [[nodiscard]] std::size_t bytes() const;       // of the messages that are kept
  [[nodiscard]] std::size_t bytes_held() const;  // of memory, used or not

 private:
  using Chunk = FlightRecording::Chunk;
  using Second = FlightRecording::Second;
  struct Kept {
    std::shared_ptr<Second> second;
    bool is_shared = false;  // with a recording: nothing is added to it any more
  };

  [[nodiscard]] std::size_t index_of(const std::string& channel);
  void begin_second(std::int64_t utime);
  void drop_oldest();
  [[nodiscard]] Chunk& chunk_for(std::size_t bytes);

  std::int64_t span_us_;
  Prologue prologue_;
  std::vector<std::string> channels_;
  std::deque<Kept> seconds_;
  std::vector<Chunk> spare_;  // empty
};

}  // namespace stanok::recording
