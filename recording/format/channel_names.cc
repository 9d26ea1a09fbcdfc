#include "recording/format/channel_names.h"

#include <algorithm>

#include "base/assert.h"

namespace stanok::recording {
namespace {

constexpr std::string_view prefix = "STANOK_";
constexpr EnumArray<Topic, std::string_view> topics{
    "SETPOINT",  "STATE",    "DRIVE",    "PROCESS",      "FORCE",     "EVENT",   "INPUT",
    "ARRIVAL",   "FEEDBACK", "PROGRAM",  "PROGRAM_READ", "WORKPIECE", "TOOL",    "TOOL_ROW",
    "SITUATION", "PATH",     "LOG_META", "LOG_TYPES",    "LOG_CHECK", "LOG_REST"};
// "_CH16_" and the longest topic of a channel.
constexpr std::size_t longest_suffix = 6 + 12;

std::string upper_case(std::string_view machine) {
  std::string name;
  for (const char c : machine.substr(0, channel_name_max - prefix.size() - longest_suffix)) {
    const bool is_lower = c >= 'a' && c <= 'z';
    const bool is_plain = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += is_lower ? static_cast<char>(c - 'a' + 'A') : is_plain ? c : '_';
  }
  return name;
}

}  // namespace

ChannelNames::ChannelNames(std::string_view machine) {
  const std::string stem = std::string(prefix) + upper_case(machine) + "_";
  for (int channel = 0; channel <= channels::channels_max; ++channel) {
    const std::string place = channel == 0 ? "" : "CH" + std::to_string(channel) + "_";
    for (const Topic topic : enum_values<Topic>()) {
      names_[channel][topic] = stem + place + std::string(topics[topic]);
      STANOK_ASSERT(names_[channel][topic].size() <= channel_name_max);
    }
  }
}

const std::string& ChannelNames::name(int channel, Topic topic) const {
  STANOK_ASSERT(channel >= 0 && channel <= channels::channels_max);
  const bool is_of_machine = topic == Topic::log_meta || topic == Topic::log_types ||
                             topic == Topic::log_check || topic == Topic::log_rest;
  const int owner = is_of_machine ? 0 : channel;
  return names_[owner][topic];
}

std::string_view topic_of(std::string_view channel_name) {
  if (!channel_name.starts_with(prefix)) return {};
  const auto topic = std::find_if(topics.begin(), topics.end(), [&](std::string_view t) {
    return channel_name.size() > t.size() && channel_name.ends_with(t) &&
           channel_name[channel_name.size() - t.size() - 1] == '_';
  });
  return topic == topics.end() ? std::string_view{} : *topic;
}

std::string_view name_of(Topic topic) {
  return topics[topic];
}

}  // namespace stanok::recording
