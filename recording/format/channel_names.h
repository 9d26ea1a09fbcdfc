// Names of the LCM channels of one machine: STANOK_<MACHINE>_CH<n>_SETPOINT and its siblings.
//
// Upper case; what is no letter or digit in the machine's name becomes '_'; a machine name that is
// too long is cut so that every name keeps within LCM's 63 bytes. Strings are made once, so that
// the stream of every cycle only looks them up.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/enum_array.h"
#include "base/numbered.h"
#include "channels/contract/output.h"

namespace stanok::recording {

inline constexpr std::size_t channel_name_max = 63;  // bytes, LCM's limit

enum class Topic {
  setpoint,
  state,
  drive,
  process,
  force,
  event,
  input,
  arrival,
  feedback,
  program,
  program_read,
  workpiece,
  tool,
  tool_row,
  situation,
  path,
  log_meta,
  log_types,
  log_check,
  log_rest
};

// A value for each channel, read by its number; 0 is the machine.
template <class Value>
using PerChannel = NumberedArray<Value, channels::channels_max + 1>;

class ChannelNames {
 public:
  explicit ChannelNames(std::string_view machine);

  // `channel` 1..channels_max, or 0 for what belongs to the machine: STANOK_<MACHINE>_EVENT.
  // LOG_META, LOG_TYPES, LOG_CHECK and LOG_REST always belong to the machine.
  [[nodiscard]] const std::string& name(int channel, Topic topic) const;

 private:
  PerChannel<EnumArray<Topic, std::string>> names_;
};

// The topic a channel name ends with, for readers of logs: "SETPOINT"; empty when it is none of
// ours.
[[nodiscard]] std::string_view topic_of(std::string_view channel_name);
[[nodiscard]] std::string_view name_of(Topic topic);

}  // namespace stanok::recording
