#include "client/offline/library/cache_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "client/offline/library/cache_hygiene.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

struct CacheOptions {
  std::string folder;
  std::string keep;
  std::string size;
  bool json = false;
};

struct CacheSum {
  std::size_t entries = 0;
  std::uint64_t bytes = 0;
};

CacheSum sum_of(const std::vector<CacheEntry>& entries) {
  CacheSum sum{.entries = entries.size()};
  for (const CacheEntry& entry : entries) sum.bytes += entry.bytes;
  return sum;
}

std::string sum_text(const CacheSum& sum) {
  constexpr double bytes_of_a_mebibyte = 1024.0 * 1024.0;
  return fmt::format("{} results, {:.1f} MiB", sum.entries,
                     static_cast<double>(sum.bytes) / bytes_of_a_mebibyte);
}

int show_cache(const CacheOptions& options) {
  const auto entries = cache_entries(options.folder);
  const CacheSum sum = sum_of(entries);
  const auto now = fs::file_time_type::clock::now();
  const double unused_days =
      entries.empty()
          ? 0.0
          : std::chrono::duration<double, std::ratio<86'400>>(now - entries.front().used).count();
  if (options.json) {
    write_json(nlohmann::ordered_json{
        {"entries", sum.entries}, {"bytes", sum.bytes}, {"unused_days_max", unused_days}});
  } else {
    write_data(
        fmt::format("{}; the oldest was used {:.0f} days ago\n", sum_text(sum), unused_days));
  }
  return 0;
}

CacheRoom room_of(const CacheOptions& options) {
  CacheRoom room;
  if (!options.keep.empty()) {
    room.unused_max = time_in(options.keep);
    if (!room.unused_max) {
      throw CLI::ValidationError("--keep", "'" + options.keep + "' is no time as 30d, 12h or 90m");
    }
  }
  if (!options.size.empty()) {
    room.bytes_max = bytes_in_size(options.size);
    if (!room.bytes_max)
      throw CLI::ValidationError("--size", "'" + options.size + "' is no size as 2G, 500M or 64k");
  }
  if (!room.unused_max && !room.bytes_max) throw CLI::RequiredError("--keep or --size");
  return room;
}

int clean_cache(const CacheOptions& options) {
  const CacheRoom room = room_of(options);
  const auto entries = cache_entries(options.folder);
  CacheSum removed;
  std::size_t failed = 0;
  for (const CacheEntry& entry :
       entries_without_room(entries, room, fs::file_time_type::clock::now())) {
    std::error_code error;
    fs::remove(entry.file, error);  // one that another cleaner removed is no error
    if (error) {
      ++failed;
    } else {
      ++removed.entries;
      removed.bytes += entry.bytes;
    }
  }
  const CacheSum all = sum_of(entries);
  const CacheSum kept{all.entries - removed.entries, all.bytes - removed.bytes};
  if (options.json) {
    write_json(nlohmann::ordered_json{{"removed", removed.entries},
                                      {"removed_bytes", removed.bytes},
                                      {"entries", kept.entries},
                                      {"bytes", kept.bytes}});
  } else {
    write_data("removed: " + sum_text(removed) + "; left: " + sum_text(kept) + "\n");
  }
  if (failed == 0) return 0;
  write_message(fmt::format("error: {} files in {} cannot be removed; check its permissions\n",
                            failed, options.folder));
  return exit_failed;
}

}  // namespace

void add_cache_commands(CLI::App& app, int& exit_code) {
  CLI::App& noun = noun_command(app, "cache", "results kept by check, simulate and batch");
  const auto add = [&](const char* verb, const char* help, int (*job)(const CacheOptions&)) {
    const auto options = std::make_shared<CacheOptions>();
    CLI::App* command = noun.add_subcommand(verb, help);
    command->add_option("FOLDER", options->folder, "folder given to --cache")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory)
        ->required();
    command->add_flag("--json", options->json, "print JSON");
    command->callback([options, job, &exit_code] { exit_code = job(*options); });
    return std::pair(command, options);
  };
  add("status", "show how many results the folder holds, and how large they are", &show_cache);
  const auto [clean, of_clean] =
      add("clean", "remove unused results; others may use the cache in the meantime", &clean_cache);
  clean
      ->add_option("--keep", of_clean->keep,
                   "remove results that have not been used for this time (30d, 12h)")
      ->type_name("TIME");
  clean
      ->add_option(
          "--size", of_clean->size,
          "remove the least recently used results until at most this much is left (2G, 500M)")
      ->type_name("SIZE");
}

}  // namespace stanok::client
