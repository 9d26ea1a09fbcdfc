#include "recording/read/setpoint_walk.h"

namespace stanok::recording {

std::optional<LogError> for_each_setpoint(const std::filesystem::path& file,
                                          const LogContents& contents, int channel,
                                          const std::function<void(const setpoint_t&)>& visit) {
  auto reader = LogReader::open(file);
  if (!reader) return reader.error();
  const auto name = contents.setpoint_channels.find(channel);
  if (name == contents.setpoint_channels.end()) return std::nullopt;
  while (const auto event = reader->next()) {
    if (event->channel != name->second) continue;
    if (const auto message = decode<setpoint_t>(event->bytes)) visit(*message);
  }
  return std::nullopt;
}

}  // namespace stanok::recording
