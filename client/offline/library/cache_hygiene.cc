#include "client/offline/library/cache_hygiene.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

constexpr seconds day{86'400};
constexpr std::size_t folder_digits = 2;  // of a digest, as ResultCache names its files
constexpr std::size_t name_digits_of_entry = 62;

bool is_hexadecimal(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool is_folder_of_entries(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  std::error_code ignored;
  return name.size() == folder_digits && is_hexadecimal(name) && !entry.is_symlink(ignored) &&
         entry.is_directory(ignored);
}

// What a file of the cache is; nothing: none of the cache's.
std::optional<CacheEntry> entry_of(const fs::directory_entry& file) {
  const std::string name = file.path().filename().string();
  const std::string_view digits = std::string_view(name).substr(0, name_digits_of_entry);
  std::error_code error;
  if (digits.size() < name_digits_of_entry || !is_hexadecimal(digits) || file.is_symlink(error) ||
      !file.is_regular_file(error))
    return std::nullopt;
  const bool is_remainder = name.size() > name_digits_of_entry;
  if (is_remainder && name[name_digits_of_entry] != '.') return std::nullopt;
  CacheEntry entry{.file = file.path(), .is_remainder = is_remainder};
  entry.bytes = file.file_size(error);
  if (error) return std::nullopt;  // removed by another one in between
  entry.used = file.last_write_time(error);
  if (error) return std::nullopt;
  return entry;
}

// A whole number and what stands behind it.
std::optional<std::pair<std::uint64_t, std::string_view>> number_and_unit(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  return std::pair(number, text.substr(static_cast<std::size_t>(end - text.data())));
}

std::optional<std::uint64_t> product(std::uint64_t number, std::uint64_t factor,
                                     std::uint64_t most) {
  if (number > most / factor) return std::nullopt;
  return number * factor;
}

}  // namespace

void note_use(const fs::path& entry) {
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  const auto used = fs::last_write_time(entry, error);
  if (!error && now - used > day) fs::last_write_time(entry, now, error);
}

std::vector<CacheEntry> cache_entries(const fs::path& folder) {
  std::vector<CacheEntry> entries;
  for (const fs::directory_entry& below : fs::directory_iterator(folder)) {
    if (!is_folder_of_entries(below)) continue;
    std::error_code ignored;
    for (const fs::directory_entry& file : fs::directory_iterator(below.path(), ignored)) {
      if (auto entry = entry_of(file)) entries.push_back(std::move(*entry));
    }
  }
  std::ranges::sort(entries, [](const CacheEntry& a, const CacheEntry& b) {
    return std::pair(a.used, a.file) < std::pair(b.used, b.file);
  });
  return entries;
}

std::vector<CacheEntry> entries_without_room(const std::vector<CacheEntry>& entries,
                                             const CacheRoom& room, fs::file_time_type now) {
  std::uint64_t bytes = 0;
  for (const CacheEntry& entry : entries) bytes += entry.bytes;
  std::vector<CacheEntry> leaving;
  for (const CacheEntry& entry : entries) {
    const auto unused = now - entry.used;
    const bool is_too_old = room.unused_max && unused > *room.unused_max;
    const bool is_too_much = room.bytes_max && bytes > *room.bytes_max;
    // A young remainder is a write that goes on.
    if (entry.is_remainder ? unused <= day : !is_too_old && !is_too_much) continue;
    bytes -= entry.bytes;
    leaving.push_back(entry);
  }
  return leaving;
}

std::optional<seconds> time_in(std::string_view text) {
  constexpr std::uint64_t most = std::uint64_t{86'400} * 365 * 100;
  const auto parts = number_and_unit(text);
  if (!parts) return std::nullopt;
  const auto& [number, unit] = *parts;
  const std::uint64_t factor = unit == "d"   ? 86'400
                               : unit == "h" ? 3'600
                               : unit == "m" ? 60
                               : unit == "s" ? 1
                                             : 0;
  if (factor == 0) return std::nullopt;
  const auto value = product(number, factor, most);
  return value ? std::optional(seconds(static_cast<std::int64_t>(*value))) : std::nullopt;
}

std::optional<std::uint64_t> bytes_in_size(std::string_view text) {
  const auto parts = number_and_unit(text);
  if (!parts) return std::nullopt;
  const auto& [number, unit] = *parts;
  unsigned shift = 0;
  if (unit == "k") {
    shift = 10;
  } else if (unit == "M") {
    shift = 20;
  } else if (unit == "G") {
    shift = 30;
  } else if (unit == "T") {
    shift = 40;
  } else if (!unit.empty()) {
    return std::nullopt;
  }
  return product(number, std::uint64_t{1} << shift, std::numeric_limits<std::uint64_t>::max());
}

}  // namespace stanok::client
