#include "jobs/cutting/keyed_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace stanok::jobs {
namespace {

// `key = value` of a line, without what stands before and behind; npos: another line.
struct KeyPlace {
  std::size_t value = std::string::npos;
  std::size_t end = 0;
};

KeyPlace place_of_key(const std::string& line, const std::string& key) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos || line.compare(begin, key.size(), key) != 0) return {};
  const std::size_t equals = line.find_first_not_of(" \t", begin + key.size());
  if (equals == std::string::npos || line[equals] != '=') return {};
  const std::size_t value = line.find_first_not_of(" \t", equals + 1);
  if (value == std::string::npos) return {};
  return {.value = value, .end = line.find_last_not_of(" \t\r") + 1};
}

// A number of TOML has a point or is an integer; these keys take both.
std::string value_text(const KeyedFigure& figure) {
  const auto& [key, estimate, digits] = figure;
  return fmt::format("{:.{}f}  # {:.{}f} to {:.{}f}", estimate.value, digits, estimate.low, digits,
                     estimate.high, digits);
}

bool begins_section(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin != std::string::npos && line[begin] == '[';
}

}  // namespace

std::string with_figures(const std::string& toml, const std::vector<KeyedFigure>& figures) {
  std::vector<KeyedFigure> open = figures;
  std::string text;
  const auto add_missing = [&] {
    for (const KeyedFigure& figure : open) text += figure.key + " = " + value_text(figure) + "\n";
    open.clear();
  };
  for (std::size_t begin = 0; begin < toml.size();) {
    const std::size_t end = std::min(toml.find('\n', begin), toml.size());
    std::string line = toml.substr(begin, end - begin);
    if (!open.empty() && begins_section(line)) add_missing();
    const auto found = std::ranges::find_if(open, [&](const KeyedFigure& figure) {
      return place_of_key(line, figure.key).value != std::string::npos;
    });
    if (found != open.end()) {
      const KeyPlace place = place_of_key(line, found->key);
      line = line.substr(0, place.value) + value_text(*found) + line.substr(place.end);
      open.erase(found);
    }
    text += line;
    if (end < toml.size()) text += "\n";
    begin = end + 1;
  }
  if (!open.empty() && !text.empty() && text.back() != '\n') text += "\n";
  add_missing();
  return text;
}

}  // namespace stanok::jobs
