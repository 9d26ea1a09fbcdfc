#include "jobs/cutting/program_feeds.h"

#include <algorithm>
#include <cctype>

namespace stanok::jobs {
namespace {

// Where the comment of a line begins.
std::size_t end_of_words(const std::string& line) {
  std::size_t end = line.size();
  for (const char* const mark : {"(", ";", "//"}) end = std::min(end, line.find(mark));
  while (end > 0 && std::isspace(static_cast<unsigned char>(line[end - 1])) != 0) --end;
  return end;
}

bool is_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+' || c == '-';
}

// The line with its word F in place of the one it has, or behind its words.
std::string with_feed(const std::string& line, const std::string& feed) {
  const std::size_t end = end_of_words(line);
  for (std::size_t k = 0; k < end; ++k) {
    if (line[k] != 'F' && line[k] != 'f') continue;
    if (k > 0 && (std::isalpha(static_cast<unsigned char>(line[k - 1])) != 0 || line[k - 1] == '_'))
      continue;
    std::size_t last = k + 1;
    while (last < end && (is_number(line[last]) || line[last] == ' ')) ++last;
    while (last > k + 1 && line[last - 1] == ' ') --last;
    if (last == k + 1) continue;
    return line.substr(0, k) + feed + line.substr(last);
  }
  return line.substr(0, end) + " " + feed + line.substr(end);
}

bool is_adaptive(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin != std::string::npos && line.compare(begin, 9, "#adaptive") == 0;
}

}  // namespace

std::string with_feeds(const std::string& text,
                       const std::map<std::uint32_t, std::vector<FedPoint>>& lines) {
  std::string result;
  std::uint32_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const auto found = lines.find(number);
    if (found == lines.end()) {
      result += is_adaptive(line) ? "// " + line : line;
    } else {
      for (const FedPoint& point : found->second) {
        result += point.words.empty() ? with_feed(line, point.feed)
                                      : "G1 " + point.words + " " + point.feed + "\n";
      }
    }
    if (end < text.size()) result += "\n";
  }
  return result;
}

}  // namespace stanok::jobs
