// Text as it stands on a screen: columns it takes, lines that fit, parts that are cut off.
//
// A character takes the columns that Unicode gives it (UAX 11, by utf8proc, whatever the locale
// is): 2 for a wide one, 0 for an accent that goes on the character before. Colours (ECMA-48,
// Select Graphic Rendition) take none. Text is UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::client {

[[nodiscard]] std::size_t screen_columns(std::string_view text);

// The text on one line: line ends and tabs are blanks, other control characters U+FFFD, so that
// what a program or file says cannot move the cursor.
[[nodiscard]] std::string one_line(std::string_view text);

// Its ASCII letters as capitals.
[[nodiscard]] std::string in_capitals(std::string_view text);

// The text with its control characters as pictures of them (␛ for ESC, U+0080 to U+009F as \x9b),
// so that a text of a file, or from the wire, gives a terminal no orders. Line ends, also those
// with CR, and tabs stay.
[[nodiscard]] std::string visible(std::string_view text);

// The lines of a text, each broken where it takes more columns: at a blank where there is one, and
// further lines are indented. At least 1 column; one character stands on a line in any case.
[[nodiscard]] std::vector<std::string> broken_lines(std::string_view text, std::size_t columns);

// Returns as much of the beginning as fits, with "..." where something was left out. No colours.
[[nodiscard]] std::string cut_to_columns(std::string_view text, std::size_t columns);

}  // namespace stanok::client
