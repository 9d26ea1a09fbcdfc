#include "client/offline/log/chosen_channels.h"

#include "client/terminal/output.h"

namespace stanok::client {

std::string channel_list(const recording::LogContents& contents) {
  std::string list;
  for (const auto& [channel, name] : contents.setpoint_channels) {
    list += (list.empty() ? "" : ", ") + std::to_string(channel);
  }
  return list.empty() ? "none" : list;
}

std::vector<int> chosen_channels(const recording::LogContents& contents, int channel) {
  std::vector<int> channels;
  for (const auto& [number, name] : contents.setpoint_channels) {
    if (channel == 0 || number == channel) channels.push_back(number);
  }
  if (channels.empty()) {
    throw std::runtime_error("no setpoints of " +
                             (channel == 0 ? "any channel" : "channel " + std::to_string(channel)) +
                             "; channels with setpoints: " + channel_list(contents));
  }
  return channels;
}

void warn_when_damaged(const recording::LogContents& contents, const std::string& file) {
  if (contents.is_sound()) return;
  write_message("warning: " + file + " is damaged; what can be read is used (stanok log info " +
                file + ")\n");
}

}  // namespace stanok::client
