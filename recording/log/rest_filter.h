// RestFilter: leaves out of a log what a machine at rest says again and again.
//
// A stretch of cycles in which every message says what the one before it of its stream said, when
// it was to come (rest_pattern.h), becomes one record, log_rest_t; LogReader makes the messages
// again, so that a log reads as if each had been written. Anything else ends the stretch: the
// record is written, then that cycle in full. A stretch has a record every few seconds: a log that
// is cut tells until when the machine rested. What is sent is held back until its cycle is over.
// One thread, that of its log.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "recording/log/log_writer.h"
#include "recording/log/rest_pattern.h"
#include "recording/stream/message_sink.h"

namespace stanok::recording {

class RestFilter final : public MessageSink {
 public:
  // The log outlives the filter.
  explicit RestFilter(LogWriter& log) : log_(log) {}

  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override;
  // Writes what is held back; nothing is sent behind it.
  void finish();

 private:
  struct Held {
    std::string channel;
    std::int64_t utime = 0;
    std::vector<std::uint8_t> bytes;
  };
  struct Joining {
    std::size_t place = 0;
    RestStream stream;
  };

  void end_cycle();
  [[nodiscard]] std::span<const Held> held() const { return {held_.data(), held_count_}; }
  [[nodiscard]] bool is_next_cycle() const;
  [[nodiscard]] bool find_repeats();
  [[nodiscard]] bool is_repeat(const Held& message, const LatestMessage& latest) const;
  void extend();
  void end_stretch();
  void write_record();
  void write_held();

  LogWriter& log_;
  int pieces_ = 0;  // of the log, when it was last written to
  int cycle_us_ = 0;
  LatestMessages latest_;
  std::vector<Held> held_;  // of one cycle; their memory is used again
  std::size_t held_count_ = 0;
  std::size_t held_bytes_ = 0;
  RestPattern pattern_;
  std::vector<Joining> joining_;  // in this cycle, from the first place to the last
  struct Stretch {
    MessageStamp first;               // seq is not used
    std::int64_t cycles = 0;          // 0: there is none
    std::vector<RestStream> streams;  // as they were before it
    bool continues = false;
  };
  Stretch stretch_;
  std::string record_channel_;
  std::int64_t records_ = 0;
};

}  // namespace stanok::recording
