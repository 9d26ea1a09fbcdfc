#include "base/text_bounds.h"

#include <algorithm>

namespace stanok {
namespace {

TextExcess excess_at(std::string_view text, std::size_t offset, std::string reason) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {.line = static_cast<unsigned>(std::count(before.begin(), before.end(), '\n')) + 1,
          .column = static_cast<unsigned>(offset - line_start) + 1,
          .text = std::move(reason)};
}

std::optional<TextExcess> excess_of_size(std::string_view text, const TextBounds& bounds) {
  if (text.size() <= bounds.bytes) return std::nullopt;
  return TextExcess{.text = "longer than " + std::to_string(bounds.bytes >> 20) + " MiB"};
}

std::string too_deep(const TextBounds& bounds) {
  return "nested deeper than " + std::to_string(bounds.nesting) + " levels";
}

// The offset behind the string whose opening quotation mark stands at `at`: on one line, up to its
// end or the end of its line (TOML 1.0, "String"; RFC 8259, section 7).
std::size_t behind_short_string(std::string_view text, std::size_t at) {
  const char mark = text[at];
  const bool has_escapes = mark == '"';
  for (++at; at < text.size(); ++at) {
    if (text[at] == mark) return at + 1;
    if (text[at] == '\n') return at;
    if (has_escapes && text[at] == '\\') ++at;
  }
  return text.size();
}

// The same for three marks. Up to two marks of the content may stand before the three that close.
std::size_t behind_long_string(std::string_view text, std::size_t at) {
  const char mark = text[at];
  const bool has_escapes = mark == '"';
  for (at += 3; at < text.size(); ++at) {
    if (has_escapes && text[at] == '\\') {
      ++at;
    } else if (text.substr(at, 3) == std::string(3, mark)) {
      const std::size_t run = text.substr(at, 5).find_first_not_of(mark);
      return at + std::min<std::size_t>(run, std::min<std::size_t>(5, text.size() - at));
    }
  }
  return text.size();
}

std::size_t behind_toml_string(std::string_view text, std::size_t at) {
  const char mark = text[at];
  const bool is_long = text.substr(at, 3) == std::string(3, mark);
  return is_long ? behind_long_string(text, at) : behind_short_string(text, at);
}

}  // namespace

// A key with dots ends at one of = [ ] { } , and the end of the line; numbers and times have one
// dot at most and end there too.
std::optional<TextExcess> toml_excess(std::string_view text, const TextBounds& bounds) {
  if (auto excess = excess_of_size(text, bounds)) return excess;
  int depth = 0;
  int dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = behind_toml_string(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    const bool opens = c == '[' || c == '{';
    const bool closes = c == ']' || c == '}';
    if (opens && ++depth > bounds.nesting) return excess_at(text, at, too_deep(bounds));
    if (closes) depth = std::max(0, depth - 1);
    if (c == '.' && ++dots >= bounds.key_parts) {
      return excess_at(text, at,
                       "a key of more than " + std::to_string(bounds.key_parts) + " parts");
    }
    if (opens || closes || c == '=' || c == ',' || c == '\n') dots = 0;
    ++at;
  }
  return std::nullopt;
}

std::optional<TextExcess> json_excess(std::string_view text, const TextBounds& bounds) {
  if (auto excess = excess_of_size(text, bounds)) return excess;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
      }
    } else if (c == '[' || c == '{') {
      if (++depth > bounds.nesting) return excess_at(text, at, too_deep(bounds));
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return std::nullopt;
}

}  // namespace stanok
