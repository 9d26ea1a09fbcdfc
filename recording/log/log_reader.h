// Reads an LCM log event by event, and goes on behind a damaged place. What a machine at rest says
// again and again is left out of the file (rest_filter.h): it comes as if it stood there.
//
// An event is the sync word, number, time and the two lengths (big endian), the channel name, the
// bytes. What cannot be an event is damage: the reader notes where it begins and goes on at the
// next sync word with a possible header. A file that was cut is read up to the cut. Sizes are
// bounded, so that a wrong length costs no memory; the file is read in pieces and may be longer
// than it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "recording/log/log_writer.h"
#include "recording/log/rest_expansion.h"

namespace stanok::recording {

struct LogEvent {
  std::int64_t number = 0;  // counted by the writer, from 0
  std::int64_t utime = 0;   // us
  std::string_view channel;
  std::span<const std::uint8_t> bytes;
  std::span<const std::uint8_t> whole{};  // with its header; empty: it was left out of the file
  std::int64_t offset = 0;                // of its first byte in the file; where it would stand

  [[nodiscard]] bool is_in_file() const { return !whole.empty(); }
};

inline constexpr std::uint32_t event_sync_word = 0xEDA1DA01;
inline constexpr std::size_t event_header_bytes = 28;  // sync word, number, time, two lengths

enum class DamageKind {
  unreadable,  // bytes that are no event, events after them
  cut,         // the file ends within an event, or within what is none
  altered      // events that are not as they were written (log_check.h)
};

struct Damage {
  DamageKind kind = DamageKind::unreadable;
  std::int64_t offset = 0;  // of its first byte in the file
  std::int64_t bytes = 0;
};

class LogReader {
 public:
  [[nodiscard]] static Expected<LogReader, LogError> open(const std::filesystem::path& file);

  // The next event, valid until the next call; nothing at the end of the file. Behind a record of
  // a stretch of rest come the messages that it stands for.
  [[nodiscard]] std::optional<LogEvent> next();

  // What was found so far, in the order of the file. Adjoining places are one.
  [[nodiscard]] const std::vector<Damage>& damage() const { return damage_; }
  [[nodiscard]] std::int64_t bytes_read() const { return window_offset_ + position(); }

 private:
  struct Header {
    std::int64_t number = 0;
    std::int64_t utime = 0;
    std::size_t channel_bytes = 0;
    std::size_t data_bytes = 0;
  };
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

  explicit LogReader(File file) : file_(std::move(file)) {}
  [[nodiscard]] std::int64_t position() const { return static_cast<std::int64_t>(at_); }
  // Makes `count` bytes from `at_` on readable; false when the file ends before.
  [[nodiscard]] std::optional<LogEvent> next_in_file();
  bool available(std::size_t count);
  [[nodiscard]] bool is_sync_word(std::size_t offset) const;
  // At `at_` + `offset`; nothing when it is no possible header or the file ends within it.
  [[nodiscard]] std::optional<Header> header_at(std::size_t offset);
  // Whether the event of that header is whole: what follows it is an event, the end of the file, or
  // damage that no event within it contradicts.
  [[nodiscard]] bool is_whole(const Header& header);
  // Moves to the next possible header behind `at_`, or to the end of the file; notes the damage.
  void skip_damage();

  File file_;
  std::vector<std::uint8_t> window_;  // a part of the file
  std::int64_t window_offset_ = 0;    // of its first byte in the file
  std::size_t at_ = 0;                // in the window: next byte that is not used up
  bool is_at_end_ = false;            // nothing is left to be read into the window
  std::vector<Damage> damage_;
  std::int64_t number_ = 0;  // of the latest event
  RestExpansion rest_;
};

}  // namespace stanok::recording
