#include "client/terminal/screen_text.h"

#include <fmt/format.h>
#include <utf8proc.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "base/place.h"
#include "base/utf8.h"

namespace stanok::client {
namespace {

constexpr char escape = '\033';
constexpr std::size_t indent = 2;

// A character or a whole colour sequence, and the columns it takes.
struct Glyph {
  std::string_view text;
  std::size_t columns = 0;
};

std::size_t columns_of(std::string_view character) {
  if (character.size() == 1) return 1;
  utf8proc_int32_t code_point = -1;
  utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(character.data()),
                   std::ssize(character), &code_point);
  return checked_size(utf8proc_charwidth(code_point));
}

Glyph glyph_at(std::string_view text, std::size_t at) {
  if (text[at] == escape) {
    const std::size_t end = text.find('m', at);
    if (end != std::string_view::npos) return {text.substr(at, end + 1 - at), 0};
  }
  const std::size_t length = character_length(text, at);
  const std::string_view character = text.substr(at, length == 0 ? 1 : length);
  return {character, columns_of(character)};
}

constexpr char delete_character = 0x7F;

bool is_control(std::string_view character) {
  const char first = character.front();
  const bool is_c1 = character.size() == 2 && first == '\xC2' &&
                     static_cast<unsigned char>(character[1]) < 0xA0;  // U+0080 to U+009F
  const bool is_c0 = character.size() == 1 && first >= 0 && first < ' ';
  return is_c1 || is_c0 || character == std::string_view(&delete_character, 1);
}

// Unicode, Control Pictures: U+2400 and the character, U+2421 for DEL; those of C1 have none.
std::string picture_of_control(std::string_view control) {
  if (control.size() == 2) return fmt::format("\\x{:02x}", static_cast<unsigned char>(control[1]));
  if (control.front() == delete_character) return "\xE2\x90\xA1";
  return {'\xE2', '\x90', static_cast<char>('\x80' + control.front())};
}

// Fills lines of a width, and begins the next one at the latest blank.
class LineBreaker {
 public:
  explicit LineBreaker(std::size_t columns)
      : columns_(columns), indent_(columns > 2 * indent ? indent : 0) {}

  void add(const Glyph& glyph) {
    if (used_ + glyph.columns > columns_ && used_ > start_) begin_line(glyph);
    const bool is_blank = glyph.text == " ";
    if (is_blank && used_ == start_ && !lines_.empty()) return;  // at the begin of a further line
    line_ += glyph.text;
    used_ += glyph.columns;
    if (is_blank) {
      blank_ = line_.size();
      used_at_blank_ = used_;
    }
  }

  std::vector<std::string> take() {
    end_line(line_);
    return std::move(lines_);
  }

 private:
  void end_line(std::string line) {
    const std::size_t last = line.find_last_not_of(' ');
    line.erase(last == std::string::npos ? 0 : last + 1);
    lines_.push_back(std::move(line));
  }

  void begin_line(const Glyph& glyph) {
    const bool breaks_here = blank_ == 0 || glyph.text == " ";
    const std::string rest = breaks_here ? std::string() : line_.substr(blank_);
    end_line(breaks_here ? line_ : line_.substr(0, blank_));
    used_ = indent_ + (breaks_here ? 0 : used_ - used_at_blank_);
    start_ = indent_;
    line_ = std::string(indent_, ' ') + rest;
    blank_ = 0;
  }

  std::size_t columns_;
  std::size_t indent_;
  std::vector<std::string> lines_;
  std::string line_;
  std::size_t start_ = 0;  // columns of the indent of the current line
  std::size_t used_ = 0;
  std::size_t blank_ = 0;  // behind the latest blank; 0: none
  std::size_t used_at_blank_ = 0;
};

}  // namespace

std::size_t screen_columns(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Glyph glyph = glyph_at(text, at);
    columns += glyph.columns;
    at += glyph.text.size();
  }
  return columns;
}

std::string one_line(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const std::string_view character = text.substr(at, length == 0 ? 1 : length);
    if (character == "\n" || character == "\t") {
      line += ' ';
    } else {
      line += length == 0 || is_control(character) ? replacement_character : character;
    }
    at += character.size();
  }
  return line;
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return capitals;
}

std::string visible(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const std::string_view character = text.substr(at, length == 0 ? 1 : length);
    const bool ends_line = text.substr(at).starts_with("\r\n");
    if (is_control(character) && character != "\n" && character != "\t" && !ends_line) {
      shown += picture_of_control(character);
    } else {
      shown += character;
    }
    at += character.size();
  }
  return shown;
}

std::vector<std::string> broken_lines(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    LineBreaker breaker(columns);
    for (std::size_t at = 0; at < line.size();) {
      const Glyph glyph = glyph_at(line, at);
      breaker.add(glyph);
      at += glyph.text.size();
    }
    for (std::string& one : breaker.take()) lines.push_back(std::move(one));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string cut_to_columns(std::string_view text, std::size_t columns) {
  if (screen_columns(text) <= columns) return std::string(text);
  constexpr std::string_view left_out = "...";
  if (columns <= left_out.size()) return std::string(left_out.substr(0, columns));
  std::size_t used = left_out.size();
  std::size_t at = 0;
  while (at < text.size()) {
    const Glyph glyph = glyph_at(text, at);
    if (used + glyph.columns > columns) break;
    used += glyph.columns;
    at += glyph.text.size();
  }
  return std::string(text.substr(0, at)) + std::string(left_out);
}

}  // namespace stanok::client
