#include "client/offline/library/result_cache.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "client/offline/library/cache_hygiene.h"
#include "client/offline/library/digest.h"
#include "client/offline/library/record.h"
#include "client/offline/library/whole_file.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int result_format = 1;

// What a text was when it was asked for: where it was found and its digest; empty: not found.
json reading_of(const recording::ProgramRead& read) {
  return {read.name, read.from, read.path, read.found ? digest_of(read.text) : ""};
}

bool is_the_same(const json& reading, const lang::Files& files) {
  const auto name = reading.at(0).get<std::string>();
  const auto from = reading.at(1).get<std::string>();
  const auto digest = reading.at(3).get<std::string>();
  const auto now = files.read(name, from);
  if (!now) return digest.empty();
  return (*now)->path == reading.at(2).get<std::string>() && digest_of((*now)->text) == digest;
}

}  // namespace

ResultCache::ResultCache(fs::path folder, std::string context)
    : folder_(std::move(folder)), context_(std::move(context)) {}

fs::path ResultCache::place_of(std::string_view program) const {
  const std::string key = Digest().add(context_).add(program).text();
  return folder_ / key.substr(0, 2) / key.substr(2);
}

std::optional<std::string> ResultCache::find(std::string_view program,
                                             const lang::Files& files) const {
  const auto kept = record_in(bytes_in(place_of(program)));
  if (!kept) return std::nullopt;
  const json& record = *kept;
  try {
    if (record.at("format") != result_format) return std::nullopt;
    auto result = record.at("result").get<std::string>();
    if (record.at("digest") != digest_of(result)) return std::nullopt;
    const json& readings = record.at("readings");
    const bool holds = std::all_of(readings.begin(), readings.end(), [&](const json& reading) {
      return is_the_same(reading, files);
    });
    if (!holds) return std::nullopt;
    note_use(place_of(program));
    return result;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

bool ResultCache::keep(std::string_view program, const std::vector<recording::ProgramRead>& reads,
                       std::string_view result) const {
  json record{{"format", result_format}, {"digest", digest_of(result)}, {"result", result}};
  json& readings = record["readings"] = json::array();
  std::set<std::pair<std::string, std::string>> asked;
  for (const recording::ProgramRead& read : reads) {
    if (asked.insert({read.name, read.from}).second) readings.push_back(reading_of(read));
  }
  return write_whole(place_of(program), bytes_of(record));
}

}  // namespace stanok::client
