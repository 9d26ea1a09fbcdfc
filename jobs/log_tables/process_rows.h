// ProcessRows: what a log tells of the cutting process of one channel, row by row, in the order of
// the file.
//
// A channel tells feed, spindle and law every 50 ms, and with its force control on the force in the
// same cycle. Both messages of a cycle are one row; a row may lack either. Times count from the
// first event of the log, as those of setpoints.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stanok_messages/force_status_t.hpp>
#include <stanok_messages/process_status_t.hpp>

#include "recording/log/log_reader.h"
#include "recording/read/log_contents.h"

namespace stanok::jobs {

struct ProcessRow {
  double time_s = 0.0;
  std::int64_t cycle = 0;
  std::optional<process_status_t> process{};
  std::optional<force_status_t> force{};
};

// Whether the log has a row of that channel.
[[nodiscard]] bool has_process_rows(const recording::LogContents& contents, int channel);

class ProcessRows {
 public:
  [[nodiscard]] static Expected<ProcessRows, recording::LogError> open(
      const std::filesystem::path& file, int channel);

  // The next one; nothing at the end of the log.
  [[nodiscard]] std::optional<ProcessRow> next();

 private:
  ProcessRows(recording::LogReader reader, int channel)
      : reader_(std::move(reader)), channel_(channel) {}
  // The row that ends where the message begins one; nothing: none ends, or it is of another
  // channel.
  template <class Message>
  [[nodiscard]] std::optional<ProcessRow> take(const recording::LogEvent& event,
                                               std::optional<Message> ProcessRow::* part);

  recording::LogReader reader_;
  int channel_;
  std::optional<std::int64_t> utime_first_;
  std::optional<ProcessRow> begun_;
};

}  // namespace stanok::jobs
