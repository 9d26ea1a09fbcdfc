#include "jobs/tools/foreign_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/utf8.h"
#include "config/text/config_error.h"
#include "config/text/text_encoding.h"

namespace stanok::jobs {
namespace {

constexpr double mm_per_inch = 25.4;
constexpr double steps_per_mm = 1e9;
constexpr double whole_double_max = 9e15;  // below 2^53: all whole numbers are doubles

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::size_t first_wrong_byte(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = character_length(text, at);
    if (length == 0) return at;
    at += length;
  }
  return at;
}

void refuse_bytes(const ForeignSource& source, std::string_view text) {
  const std::size_t at = first_wrong_byte(text);
  const std::string_view before = text.substr(0, at);
  const auto line = static_cast<unsigned>(std::ranges::count(before, '\n')) + 1;
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  throw config::ConfigError(
      {{.file = source.file.string(),
        .line = line,
        .column = static_cast<unsigned>(character_count(before.substr(line_begin))) + 1,
        .text = "not UTF-8; save the file as UTF-8"}});
}

std::string_view without_plus(std::string_view text) {
  const bool has_plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
  return has_plus ? text.substr(1) : text;
}

}  // namespace

std::string text_of(const ForeignSource& source) {
  std::string text = config::text_from(source.bytes, "");
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  if (!is_utf8(text)) refuse_bytes(source, text);
  return text;
}

std::vector<TextLine> lines_of(std::string_view text) {
  std::vector<TextLine> lines;
  unsigned number = 1;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back({number++, line});
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

std::string in_one_line(std::string_view text) {
  std::string line(text);
  for (char& letter : line) {
    if ((letter >= 0 && letter < ' ') || letter == '\x7F') letter = ' ';
  }
  return std::string(trimmed(line));
}

std::string shortened(std::string_view text) {
  constexpr std::size_t bytes_max = 60;
  const std::string line = in_one_line(text);
  if (line.size() <= bytes_max) return line;
  return std::string(cut_to(line, bytes_max)) + "...";
}

std::optional<double> number_of_text(std::string_view text) {
  text = without_plus(text);
  if (text.find_first_not_of("0123456789.-+eE") != std::string_view::npos) return std::nullopt;
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<int> whole_number_of_text(std::string_view text) {
  text = without_plus(text);
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

std::string plain_number(double value) {
  std::array<char, 400> text{};  // 1e308 has 309 digits, 5e-324 has 326 signs
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

std::string fixed_number(double value, int decimals) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  std::string written(text.data(), end);
  // -0.000 is 0.000.
  if (written.find_first_not_of("-0.") == std::string::npos) std::erase(written, '-');
  return written;
}

double mm_of(double value, LengthUnit unit) {
  if (unit == LengthUnit::mm) return value;
  const double value_mm = value * mm_per_inch;
  const double steps = value_mm * steps_per_mm;
  return std::abs(steps) < whole_double_max ? std::round(steps) / steps_per_mm : value_mm;
}

double in_unit(double value_mm, LengthUnit unit) {
  return unit == LengthUnit::mm ? value_mm : value_mm / mm_per_inch;
}

std::string_view name_of(LengthUnit unit) {
  return unit == LengthUnit::mm ? "mm" : "inch";
}

}  // namespace stanok::jobs
