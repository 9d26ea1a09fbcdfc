#include "recording/log/log_reader.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <utility>

#include "recording/log/big_endian.h"

namespace stanok::recording {
namespace {

constexpr std::size_t sync_bytes = 4;
constexpr std::size_t read_bytes = 1UL << 20;
constexpr std::size_t name_bytes_max = 63;          // LCM's limit
constexpr std::size_t data_bytes_max = 16UL << 20;  // our largest message has 4 kB

}  // namespace

Expected<LogReader, LogError> LogReader::open(const std::filesystem::path& file) {
  const auto fail = [&](int error) {
    return Unexpected<LogError>(log_error("cannot read " + file.string(), error));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return fail(EISDIR);
  File stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (stream == nullptr) return fail(errno);
  return LogReader(std::move(stream));
}

std::optional<LogEvent> LogReader::next() {
  if (const auto repeated = rest_.next())
    return LogEvent{.number = number_,
                    .utime = repeated->utime,
                    .channel = repeated->channel,
                    .bytes = repeated->bytes,
                    .offset = bytes_read()};
  const auto event = next_in_file();
  if (!event) return std::nullopt;
  number_ = event->number;
  rest_.take(event->channel, event->bytes);
  return event;
}

std::optional<LogEvent> LogReader::next_in_file() {
  while (available(1)) {
    const auto header = header_at(0);
    if (!header || !is_whole(*header)) {
      skip_damage();
      continue;
    }
    const std::uint8_t* name = window_.data() + at_ + event_header_bytes;
    LogEvent event{.number = header->number,
                   .utime = header->utime,
                   .channel = {reinterpret_cast<const char*>(name), header->channel_bytes},
                   .bytes = {name + header->channel_bytes, header->data_bytes},
                   .whole = {name - event_header_bytes,
                             event_header_bytes + header->channel_bytes + header->data_bytes},
                   .offset = bytes_read()};
    at_ += event.whole.size();
    return event;
  }
  return std::nullopt;
}

bool LogReader::available(std::size_t count) {
  while (window_.size() - at_ < count) {
    if (is_at_end_) return false;
    if (at_ >= read_bytes) {
      window_.erase(window_.begin(), window_.begin() + position());
      window_offset_ += position();
      at_ = 0;
    }
    const std::size_t size = window_.size();
    window_.resize(size + read_bytes);
    const std::size_t read = std::fread(window_.data() + size, 1, read_bytes, file_.get());
    window_.resize(size + read);
    is_at_end_ = read < read_bytes;
  }
  return true;
}

bool LogReader::is_sync_word(std::size_t offset) const {
  return big_endian({window_.data() + at_ + offset, sync_bytes}) == event_sync_word;
}

std::optional<LogReader::Header> LogReader::header_at(std::size_t offset) {
  if (!available(offset + event_header_bytes) || !is_sync_word(offset)) return std::nullopt;
  const std::uint8_t* bytes = window_.data() + at_ + offset;
  const Header header{.number = static_cast<std::int64_t>(big_endian({bytes + 4, 8})),
                      .utime = static_cast<std::int64_t>(big_endian({bytes + 12, 8})),
                      .channel_bytes = big_endian({bytes + 20, 4}),
                      .data_bytes = big_endian({bytes + 24, 4})};
  const bool is_possible = header.channel_bytes > 0 && header.channel_bytes <= name_bytes_max &&
                           header.data_bytes <= data_bytes_max;
  return is_possible ? std::optional(header) : std::nullopt;
}

bool LogReader::is_whole(const Header& header) {
  const std::size_t size = event_header_bytes + header.channel_bytes + header.data_bytes;
  if (!available(size)) return false;
  if (!available(size + 1)) return true;
  if (available(size + sync_bytes) && is_sync_word(size)) return true;
  for (std::size_t offset = sync_bytes; offset < size; ++offset) {
    if (header_at(offset)) return false;
  }
  return true;
}

void LogReader::skip_damage() {
  const std::int64_t begin = bytes_read();
  do {
    ++at_;
  } while (available(event_header_bytes) && !header_at(0));
  const bool is_cut = !available(event_header_bytes);
  if (is_cut) at_ = window_.size();
  const DamageKind kind = is_cut ? DamageKind::cut : DamageKind::unreadable;
  const bool adjoins = !damage_.empty() && damage_.back().offset + damage_.back().bytes == begin;
  if (adjoins) {
    damage_.back().kind = kind;
    damage_.back().bytes += bytes_read() - begin;
  } else {
    damage_.push_back({kind, begin, bytes_read() - begin});
  }
}

}  // namespace stanok::recording
