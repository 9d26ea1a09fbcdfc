// What a log holds: its description, the messages of every channel, what is missing or damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stanok_messages/setpoint_t.hpp>
#include <string>
#include <vector>

#include "base/expected.h"
#include "recording/format/log_description.h"
#include "recording/log/log_check.h"
#include "recording/log/log_reader.h"

namespace stanok::recording {

// The messages of one LCM channel.
struct ChannelContents {
  std::string type;           // "setpoint_t"; empty: not one of ours
  std::int64_t messages = 0;  // also those that cannot be decoded
  std::int64_t bytes = 0;     // in the file, without the headers of the log
  std::int64_t undecodable = 0;
  std::int64_t missing = 0;  // by their running numbers, setpoints also by their cycles
  std::int64_t utime_first = 0;
  std::int64_t utime_last = 0;
  std::int64_t cycle_first = 0;  // of messages that could be decoded
  std::int64_t cycle_last = 0;
};

struct LogContents {
  std::optional<LogDescription> description;        // the first one in the log
  std::map<std::string, ChannelContents> channels;  // by name
  std::map<int, std::string> setpoint_channels;     // number of the machine channel to LCM name
  std::int64_t events = 0;
  std::int64_t bytes = 0;
  std::int64_t utime_first = 0;
  std::int64_t utime_last = 0;
  std::vector<Damage> damage;
  LogCoverage coverage;

  // Nothing is damaged, cut or undecodable. Messages may be missing: lost before they were written.
  [[nodiscard]] bool is_sound() const;
  // The file ends within an event, or lacks the trailer that it should have.
  [[nodiscard]] bool is_cut() const;
};

[[nodiscard]] Expected<LogContents, LogError> read_contents(const std::filesystem::path& file);

// The same for whoever reads the events of a log himself.
class ContentsReading {
 public:
  ContentsReading();
  ~ContentsReading();
  ContentsReading(const ContentsReading&) = delete;
  ContentsReading& operator=(const ContentsReading&) = delete;

  // In the order of the file. The setpoint that the event is; nullptr: it is none.
  const setpoint_t* take(const LogEvent& event);
  // Of what was taken: up to here events may be believed. A log without checks is believed, and
  // what lies behind the last check is not, unless there is none.
  [[nodiscard]] std::int64_t usable_bytes() const;
  [[nodiscard]] bool has_checks() const { return checks_.has_checks(); }
  // Nothing behind what is usable now will ever be.
  [[nodiscard]] bool is_damaged() const { return checks_.has_faults(); }
  // Behind the last event of `reader`.
  [[nodiscard]] LogContents finish(const LogReader& reader);

 private:
  class Count;
  LogContents contents_;
  CheckReading checks_;
  std::unique_ptr<Count> count_;
  std::int64_t bytes_ = 0;           // of all events
  std::int64_t setpoint_bytes_ = 0;  // of those that are setpoints
};

// The description of the channel of that number; nothing when the log does not have it.
[[nodiscard]] const ChannelDescription* description_of(const LogContents& contents, int channel);

// Axes of a channel with that many axes: as described, else "A1", "A2"...
[[nodiscard]] std::vector<AxisDescription> axes_of(const LogContents& contents, int channel,
                                                   int axis_count);

}  // namespace stanok::recording
