#include "config/files/foreign_tables.h"

#include <memory>

namespace stanok::config {
namespace {

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

// "T1 P1 Z+77.125": a letter and a number, twice.
bool is_line_of_linuxcnc(std::string_view line) {
  constexpr std::string_view letters = "TPXYZABCUVWDIJQ";
  if (line.size() < 2 || line[0] != 'T' || !is_digit(line[1])) return false;
  const std::size_t end = line.find_first_not_of("0123456789", 1);
  if (end == std::string_view::npos || line[end] == ';') return true;
  if (line[end] != ' ' && line[end] != '\t') return false;
  const std::size_t next = line.find_first_not_of(" \t", end);
  if (next == std::string_view::npos || line[next] == ';') return true;
  return letters.find(line[next]) != std::string_view::npos && line.size() > next + 1 &&
         std::string_view("0123456789+-.").find(line[next + 1]) != std::string_view::npos;
}

}  // namespace

toml::source_region ForeignTables::place_in(const std::filesystem::path& file) const {
  toml::source_region place;
  place.path = std::make_shared<const std::string>(file.native());
  place.begin = {line, 1};
  return place;
}

std::optional<ForeignTables> foreign_tables_in(std::string_view text) {
  if (text.starts_with("PK\x03\x04")) return ForeignTables{"a tool library of Fusion"};
  unsigned line = 1;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view whole = text.substr(0, end);
    const std::size_t begin = whole.find_first_not_of(" \t");
    if (begin != std::string_view::npos && whole[begin] != ';') {
      const std::string_view first = whole.substr(begin);
      if (is_line_of_linuxcnc(first)) return ForeignTables{"a LinuxCNC tool table", line};
      if (first.front() == '{') return ForeignTables{"a tool library in JSON", line};
      return std::nullopt;
    }
    if (end == std::string_view::npos) return std::nullopt;
    const bool is_crlf = text.substr(end).starts_with("\r\n");
    text.remove_prefix(end + (is_crlf ? 2 : 1));
    ++line;
  }
  return std::nullopt;
}

}  // namespace stanok::config
