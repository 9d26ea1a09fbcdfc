#include "daemon/publish/log_retention.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_per_gb = 1e9;
constexpr double bytes_per_mb = 1e6;
constexpr double s_per_day = 86'400.0;
constexpr int pieces_min = 4;  // of all logs: the oldest ones go, and not all at once
// Sixteen channels write 10 MB/s; some seconds of it, and what the disk counts late.
constexpr double mb_between_looks = 64.0;
constexpr std::string_view flight_word = "flight-";
constexpr std::string_view ending = ".lcm";

bool take(std::string_view word, std::string_view& text) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

bool take_digits(std::size_t count, std::string_view& text) {
  if (text.size() < count || !std::all_of(text.begin(), text.begin() + static_cast<long>(count),
                                          [](char c) { return c >= '0' && c <= '9'; }))
    return false;
  text.remove_prefix(count);
  return true;
}

std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

std::string in_gb(std::int64_t bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f GB", static_cast<double>(bytes) / bytes_per_gb);
  return text.data();
}

}  // namespace

// MACHINE-[flight-]YYYYMMDD-HHMMSS[-n][.piece].lcm
std::optional<LogFileName> log_file_name_of(std::string_view file_name, std::string_view machine) {
  LogFileName name;
  std::string_view rest = file_name;
  if (!take(machine, rest) || !take("-", rest)) return std::nullopt;
  name.is_flight = take(flight_word, rest);
  if (!take_digits(8, rest) || !take("-", rest) || !take_digits(6, rest)) return std::nullopt;
  if (take("-", rest) && !take_number(rest)) return std::nullopt;
  name.log = std::string(file_name.substr(0, file_name.size() - rest.size()));
  if (rest != ending) {
    if (!take(".", rest)) return std::nullopt;
    const auto piece = take_number(rest);
    if (!piece) return std::nullopt;
    name.piece = *piece;
  }
  return rest == ending ? std::optional(name) : std::nullopt;
}

LogLimits log_limits_of(const config::RecorderConfig& config) {
  LogLimits limits;
  limits.bytes_max = std::llround(config.logs_max_gb * bytes_per_gb);
  limits.age_max = std::chrono::seconds(std::llround(config.logs_max_days * s_per_day));
  limits.free_bytes_min = std::llround(config.free_space_min_gb * bytes_per_gb);
  limits.piece_bytes_max = std::llround(config.size_mb * bytes_per_mb);
  limits.bytes_between_looks = std::llround(mb_between_looks * bytes_per_mb);
  if (limits.bytes_max == 0) return limits;
  limits.piece_bytes_max = std::min(limits.piece_bytes_max, limits.bytes_max / pieces_min);
  limits.bytes_between_looks =
      std::min(limits.bytes_between_looks, limits.bytes_max / (std::int64_t{2} * pieces_min));
  return limits;
}

LogDisk disk_of_this_computer() {
  return {.now = [] { return std::chrono::system_clock::now(); },
          .free_bytes = [](const fs::path& folder) -> std::optional<std::int64_t> {
            std::error_code error;
            const fs::space_info space = fs::space(folder, error);
            if (error) return std::nullopt;
            return static_cast<std::int64_t>(space.available);
          }};
}

struct LogRetention::File {
  fs::path path;
  std::int64_t bytes = 0;
  std::chrono::system_clock::time_point written;
  bool is_flight = false;
  bool is_open = false;
  std::string log;
  int piece = 1;
};

LogRetention::LogRetention(fs::path directory, std::string machine, const LogLimits& limits,
                           LogDisk disk)
    : directory_(std::move(directory)),
      machine_(std::move(machine)),
      limits_(limits),
      disk_(std::move(disk)) {}

// In the order in which they go. A file that is removed meanwhile is not there.
std::vector<LogRetention::File> LogRetention::files(const fs::path& open) const {
  std::vector<File> files;
  std::error_code error;
  for (auto entry = fs::directory_iterator(directory_, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const auto name = log_file_name_of(entry->path().filename().string(), machine_);
    std::error_code gone;
    if (!name || entry->symlink_status(gone).type() != fs::file_type::regular) continue;
    const auto bytes = static_cast<std::int64_t>(entry->file_size(gone));
    const auto written = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
        std::chrono::file_clock::to_sys(entry->last_write_time(gone)));
    if (gone) continue;
    files.push_back(
        {entry->path(), bytes, written, name->is_flight, false, name->log, name->piece});
  }
  std::ranges::sort(files, [](const File& a, const File& b) {
    return std::tie(a.written, a.log, a.piece) < std::tie(b.written, b.log, b.piece);
  });
  const auto newest_flight = std::ranges::find_if(files.rbegin(), files.rend(), &File::is_flight);
  if (newest_flight != files.rend())
    std::rotate(newest_flight.base() - 1, newest_flight.base(), files.end());
  const std::string log = open.stem().string();
  File* newest_piece = nullptr;
  for (File& file : files) {
    if (file.log != log) continue;
    if (newest_piece == nullptr || file.piece > newest_piece->piece) newest_piece = &file;
  }
  if (newest_piece != nullptr) newest_piece->is_open = true;
  return files;
}

bool LogRetention::is_too_old(const File& file) const {
  return limits_.age_max.count() > 0 && disk_.now() - file.written > limits_.age_max;
}

// A log that rests goes on when there is room for twice as much: it does not begin and end with
// every file of somebody else.
bool LogRetention::has_room(const KeptLogs& kept, std::int64_t wanted_bytes) const {
  const std::int64_t soon = wanted_bytes + (rests_ ? 2 : 1) * limits_.bytes_between_looks;
  const bool is_small = limits_.bytes_max == 0 || kept.bytes + soon <= limits_.bytes_max;
  const bool leaves_space = limits_.free_bytes_min == 0 || !kept.free_bytes ||
                            *kept.free_bytes - soon >= limits_.free_bytes_min;
  return is_small && leaves_space;
}

std::string LogRetention::why_no_room(const KeptLogs& kept, std::int64_t wanted_bytes) const {
  if (has_room(kept, wanted_bytes)) return {};
  if (limits_.free_bytes_min > 0 && kept.free_bytes) {
    return in_gb(*kept.free_bytes) + " are free on the disk of " + directory_.string() + ", and " +
           in_gb(limits_.free_bytes_min) + " must stay free (free_space_min_gb)";
  }
  return "the logs in " + directory_.string() + " use " + in_gb(kept.bytes) + " of " +
         in_gb(limits_.bytes_max) + " (logs_max_gb)";
}

KeptLogs LogRetention::tidy(const fs::path& open, std::int64_t wanted_bytes) {
  const std::lock_guard lock(mutex_);
  const std::vector<File> found = files(open);
  // The folder need not be there yet.
  fs::path on_disk = directory_;
  std::error_code error;
  while (!fs::exists(on_disk, error) && on_disk.has_relative_path())
    on_disk = on_disk.parent_path();
  KeptLogs kept;
  kept.files = static_cast<std::int64_t>(found.size());
  for (const File& file : found) kept.bytes += file.bytes;
  kept.free_bytes = disk_.free_bytes(on_disk);
  for (const File& file : found) {
    if (file.is_open || (!is_too_old(file) && has_room(kept, wanted_bytes))) continue;
    if (!fs::remove(file.path, error) || error) continue;
    --kept.files;
    kept.bytes -= file.bytes;
    kept.free_bytes = disk_.free_bytes(on_disk);
  }
  kept.no_room = why_no_room(kept, wanted_bytes);
  if (wanted_bytes == 0) rests_ = !kept.no_room.empty();
  kept_ = kept;
  return kept;
}

KeptLogs LogRetention::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

}  // namespace stanok::daemon
