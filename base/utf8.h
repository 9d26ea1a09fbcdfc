// Text as UTF-8: where its characters begin, where it may be cut, and bytes that are none repaired.
//
// What comes from outside (program texts, file names, messages of the system) may hold any bytes.
// It becomes text here: each byte that belongs to no character is replaced by U+FFFD. Program texts
// pass here once when they are loaded, all that leaves as JSON, as text of a message or on a
// terminal once more. Source: RFC 3629, section 4 (no overlong forms, no surrogates). Positions
// and counts of characters are those of code points.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/rt_safe.h"

namespace stanok {

// U+FFFD, the replacement character.
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

// Whether the byte is the second or a later one of a character.
[[nodiscard]] constexpr bool continues_character(char byte) RT_SAFE {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// Bytes of the character that begins at `at`; 0: none does.
[[nodiscard]] constexpr std::size_t character_length(std::string_view text, std::size_t at)
    RT_SAFE {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const unsigned lead = byte(0);
  if (at >= text.size() || (lead >= 0x80 && lead < 0xC2) || lead > 0xF4) return 0;
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned behind_lead = byte(1);
  const bool overlong =
      (lead == 0xE0 && behind_lead < 0xA0) || (lead == 0xF0 && behind_lead < 0x90);
  const bool outside = (lead == 0xED && behind_lead > 0x9F) || (lead == 0xF4 && behind_lead > 0x8F);
  return overlong || outside ? 0 : length;
}

// The longest beginning of `text` of at most `bytes_max` bytes that ends with a whole character.
[[nodiscard]] constexpr std::string_view cut_to(std::string_view text, std::size_t bytes_max)
    RT_SAFE {
  if (text.size() <= bytes_max) return text;
  constexpr std::size_t longest_character = 4;
  for (std::size_t back = 1; back < longest_character && back <= bytes_max; ++back) {
    if (continues_character(text[bytes_max - back])) continue;
    const bool is_cut = character_length(text, bytes_max - back) > back;
    return std::string_view(text.begin(), text.begin() + (is_cut ? bytes_max - back : bytes_max));
  }
  return std::string_view(text.begin(), text.begin() + bytes_max);
}

[[nodiscard]] bool is_utf8(std::string_view text);
// The text, with U+FFFD for each byte that belongs to no character.
[[nodiscard]] std::string valid_utf8(std::string_view text);

// Of a text that is UTF-8.
[[nodiscard]] std::size_t character_count(std::string_view text);
// The byte where a character begins, counted from 0; the end of the text behind the last one.
[[nodiscard]] std::size_t offset_of_character(std::string_view text, std::size_t character);

}  // namespace stanok
