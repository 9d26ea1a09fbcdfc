#include "process/grinding/control_line.h"

#include <charconv>
#include <limits>

#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr std::string_view blanks = " \t\r\n";

int decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

// Whether a word at the beginning of a line is meant as a number, right or wrong.
bool looks_like_number(std::string_view word) {
  const std::size_t sign = word.find_first_not_of("+-");
  if (sign == std::string_view::npos) return false;
  constexpr std::string_view digits = "0123456789.,";
  return digits.find(word[sign]) != std::string_view::npos || word.substr(sign) == "nan" ||
         word.substr(sign) == "inf";
}

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
    lines.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

bool is_blank(std::string_view line) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
  return line.find_first_not_of(blanks) == std::string_view::npos;
}

ControlLine split_line(std::string_view line, int numbers_max) {
  ControlLine parts;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::size_t place = line.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  std::size_t from = 0;
  while (static_cast<int>(parts.numbers.size()) < numbers_max) {
    const std::size_t begin = line.find_first_not_of(blanks, place);
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    if (!looks_like_number(word)) break;
    parts.between.emplace_back(line.substr(from, begin - from));
    parts.numbers.emplace_back(word);
    from = place = end;
  }
  parts.between.emplace_back(line.substr(from));
  return parts;
}

double value_of(std::string_view number) {
  double value = 0.0;
  const char* first = number.data();
  const char* last = first + number.size();
  if (number.starts_with('+')) ++first;
  const auto [end, error] = std::from_chars(first, last, value);
  const bool is_whole = error == std::errc() && end == last;
  return is_whole ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string line_text(const ControlLine& line, const std::vector<double>& values) {
  std::string text;
  for (std::size_t k = 0; k < line.numbers.size(); ++k) {
    const std::string& number = line.numbers[k];
    const bool is_same = value_of(number) == values[k];
    text += line.between[k];
    text += is_same ? number : number_text(values[k], decimals_of(number));
  }
  return text + line.between.back();
}

}  // namespace stanok::process
