// What a log holds: its description, the messages of every channel, what is missing or damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
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
  std::int64_t bytes = 0;     // without the headers of the log
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

// The description of the channel of that number; nothing when the log does not have it.
[[nodiscard]] const ChannelDescription* description_of(const LogContents& contents, int channel);

// Axes of a channel with that many axes: as described, else "A1", "A2"...
[[nodiscard]] std::vector<AxisDescription> axes_of(const LogContents& contents, int channel,
                                                   int axis_count);

}  // namespace stanok::recording
