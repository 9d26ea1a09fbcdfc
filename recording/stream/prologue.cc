#include "recording/stream/prologue.h"

#include "recording/format/channel_names.h"

namespace stanok::recording {

void Prologue::take(const std::string& channel, std::span<const std::uint8_t> bytes) {
  const std::string_view topic = topic_of(channel);
  const bool is_meta = topic == name_of(Topic::log_meta);
  const bool is_types = topic == name_of(Topic::log_types);
  const bool is_text = topic == name_of(Topic::program) || topic == name_of(Topic::program_read);
  if (!is_meta && !is_types && !is_text) return;
  auto kept = std::make_shared<const Kept>(Kept{channel, {bytes.begin(), bytes.end()}});
  if (is_meta) meta_ = kept;
  if (is_types) types_ = kept;
  if (is_text) texts_.push_back(std::move(kept));
}

void Prologue::send_to(MessageSink& sink, std::int64_t utime) const {
  if (meta_) sink.send(meta_->channel, utime, meta_->bytes);
  if (types_) sink.send(types_->channel, utime, types_->bytes);
  for (const auto& text : texts_) sink.send(text->channel, utime, text->bytes);
}

}  // namespace stanok::recording
