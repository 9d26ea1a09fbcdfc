// What belongs to the language but not to this release, and what works instead: for the help of
// E2090 and the table of docs/reference/language.md ("Not in this release").
#pragma once

#include <span>
#include <string_view>

namespace stanok::lang {

struct UnsupportedWord {
  std::string_view word;     // "G34"
  std::string_view meaning;  // what it would do
  std::string_view instead;  // what does the same today
};

[[nodiscard]] std::span<const UnsupportedWord> unsupported_words();

// The row of a word, or nullptr: the code table alone knows more about it.
[[nodiscard]] const UnsupportedWord* find_unsupported_word(std::string_view word);

}  // namespace stanok::lang
