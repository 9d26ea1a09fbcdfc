#include "jobs/cutting/program_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

namespace stanok::jobs {
namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

// Without its comment, in capitals.
std::string words_of(const std::string& line) {
  std::size_t end = line.size();
  for (const char* const mark : {"(", ";", "//"}) end = std::min(end, line.find(mark));
  std::string words = line.substr(0, end);
  std::ranges::transform(words, words.begin(), upper);
  return words;
}

}  // namespace

ProgramText::ProgramText(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  for (std::uint32_t number = 1; std::getline(lines, line); ++number) lines_[number] = line;
}

const std::string* ProgramText::line(std::uint32_t number) const {
  const auto found = lines_.find(number);
  return found == lines_.end() ? nullptr : &found->second;
}

bool ProgramText::has_word(const std::string& line, const std::string& word) {
  const std::string words = words_of(line);
  for (std::size_t at = words.find(word); at != std::string::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_letter(words[at - 1]);
    const bool ends =
        end == words.size() ||
        (std::isdigit(static_cast<unsigned char>(words[end])) == 0 && words[end] != '.');
    if (begins && ends) return true;
  }
  return false;
}

std::optional<double> ProgramText::value(const std::string& line, char word) {
  const std::size_t place = line.find(word);
  if (place == std::string::npos) return std::nullopt;
  double number = 0.0;
  const char* const begin = line.data() + place + 1;
  if (std::from_chars(begin, line.data() + line.size(), number).ec != std::errc{})
    return std::nullopt;
  return number;
}

bool ProgramText::has_feed_expression(const std::string& line) {
  const std::string words = words_of(line);
  for (std::size_t at = 0; at + 1 < words.size(); ++at) {
    if (words[at] != 'F' || (at > 0 && is_letter(words[at - 1]))) continue;
    const std::size_t next = words.find_first_not_of(" \t", at + 1);
    if (next == std::string::npos || is_letter(words[next])) continue;
    const bool is_number = std::isdigit(static_cast<unsigned char>(words[next])) != 0 ||
                           words[next] == '.' || words[next] == '+' || words[next] == '-';
    if (!is_number) return true;
  }
  return false;
}

}  // namespace stanok::jobs
