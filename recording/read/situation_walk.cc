#include "recording/read/situation_walk.h"

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"

namespace stanok::recording {

Expected<SituationWalk, LogError> SituationWalk::open(const std::filesystem::path& file,
                                                      int channel) {
  auto reader = LogReader::open(file);
  if (!reader) return Unexpected<LogError>(reader.error());
  return SituationWalk(std::move(*reader), channel);
}

std::optional<situation_t> SituationWalk::next() {
  while (const auto event = reader_.next()) {
    if (topic_of(event->channel) != name_of(Topic::situation)) continue;
    const auto told = decode<situation_t>(event->bytes);
    if (!told || (channel_ != 0 && told->channel != channel_)) continue;
    const auto [newest, is_first] = newest_.try_emplace(told->channel, told->number);
    if (!is_first && newest->second == told->number) continue;
    newest->second = told->number;
    return told;
  }
  return std::nullopt;
}

}  // namespace stanok::recording
