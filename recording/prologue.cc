#include "recording/prologue.h"

#include "recording/channel_names.h"

namespace stanok::recording {

void Prologue::take(const std::string& channel, std::span<const std::uint8_t> bytes) {
  const std::string_view topic = topic_of(channel);
  const bool is_text = topic == name_of(Topic::program) || topic == name_of(Topic::program_read);
  if (topic == name_of(Topic::log_meta)) meta_ = {channel, {bytes.begin(), bytes.end()}};
  if (is_text) texts_.push_back({channel, {bytes.begin(), bytes.end()}});
}

void Prologue::send_to(MessageSink& sink, std::int64_t utime) const {
  if (!meta_.channel.empty()) sink.send(meta_.channel, utime, meta_.bytes);
  for (const Kept& text : texts_) sink.send(text.channel, utime, text.bytes);
}

}  // namespace stanok::recording
