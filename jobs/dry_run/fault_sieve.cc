#include "jobs/dry_run/fault_sieve.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

namespace stanok::jobs {
namespace {

// Faults of the state that the blocks before leave behind: feed, speed, tool, modes.
constexpr auto of_state = std::to_array<std::string_view>(
    {"E4012", "E4020", "E4021", "E4036", "E4051", "E4052", "E4055", "E4056", "E4064", "E4065",
     "E4140", "E4141", "E4142", "E4150", "E4301", "E4303", "E4333", "E4343", "E4344", "E5021"});
// Faults of the way from where the axes stand.
constexpr auto of_geometry = std::to_array<std::string_view>(
    {"E4032", "E4033", "E4035", "E4067", "E4068", "E4070", "E4143", "E4144", "E4145", "E4146",
     "E4147", "E4148", "E4151", "E4152", "E4321", "E5022", "E5101", "E5102", "E5103", "E5104"});

template <class Codes>
bool is_among(const Codes& codes, std::string_view code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

}  // namespace

bool FaultSieve::is_of_its_block(const Diagnostic& diagnostic) {
  return diagnostic.code.starts_with("E4") && !is_among(of_state, diagnostic.code) &&
         !is_among(of_geometry, diagnostic.code);
}

bool FaultSieve::lets_through(const Diagnostic& diagnostic) {
  if (is_among(of_geometry, diagnostic.code)) return is_position_known_;
  if (!is_among(of_state, diagnostic.code)) return true;
  return told_.insert(diagnostic.code).second || passed_ == 0;
}

bool FaultSieve::is_new(const Diagnostic& diagnostic) {
  const Place& place = diagnostic.place;
  return places_.insert({diagnostic.code, place.file, place.line, place.column}).second;
}

void sort_by_place(Diagnostics& diagnostics, const std::string& program) {
  std::map<std::string, std::size_t> files{{program, 0}};
  for (const Diagnostic& diagnostic : diagnostics)
    files.emplace(diagnostic.place.file, files.size());
  const auto place = [&](const Diagnostic& diagnostic) {
    return std::tuple(files.at(diagnostic.place.file), diagnostic.place.line,
                      diagnostic.place.column);
  };
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
}

}  // namespace stanok::jobs
