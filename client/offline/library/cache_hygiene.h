// What lies in a cache of results (ResultCache), and what of it nobody wants any more.
//
// An entry is used when it is written and when a result is taken from it; the time of its file says
// when that was, to a day. Entries may be removed while others read and write: who has one open
// reads it to its end, who comes later makes the result anew. Files that are none of the cache's
// are never touched, so that a wrong folder loses nothing.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace stanok::client {

// Notes that an entry was used, where that is not known of this day. A folder that cannot be
// written stays as it is.
void note_use(const std::filesystem::path& entry);

struct CacheEntry {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  std::filesystem::file_time_type used{};
  bool is_remainder = false;  // of a write that was cut off
};

// All entries, the one that was not used for the longest time first.
[[nodiscard]] std::vector<CacheEntry> cache_entries(const std::filesystem::path& folder);

struct CacheRoom {
  std::optional<std::chrono::seconds> unused_max{};  // nothing: any age
  std::optional<std::uint64_t> bytes_max{};          // of all; nothing: any size
};

// Those of `entries` that have no room, at the time `now`: too old, then the oldest until the
// others fit, and remainders of more than a day.
[[nodiscard]] std::vector<CacheEntry> entries_without_room(const std::vector<CacheEntry>& entries,
                                                           const CacheRoom& room,
                                                           std::filesystem::file_time_type now);

// "30d", "12h", "90m", "45s"; nothing where it is not of this form.
[[nodiscard]] std::optional<std::chrono::seconds> time_in(std::string_view text);
// "2G", "500M", "64k", "1000": bytes, by powers of 1024.
[[nodiscard]] std::optional<std::uint64_t> bytes_in_size(std::string_view text);

}  // namespace stanok::client
