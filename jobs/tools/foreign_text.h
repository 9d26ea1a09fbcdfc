// Texts of foreign files: their lines, their numbers and their units.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

struct TextLine {
  unsigned number = 1;
  std::string_view text;  // without its end
};

// The text of a file as UTF-8, without a byte order mark. Throws ConfigError where it has bytes
// that are not UTF-8, with their place.
[[nodiscard]] std::string text_of(const ForeignSource& source);

[[nodiscard]] std::vector<TextLine> lines_of(std::string_view text);
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string in_lower_case(std::string_view text);
// Line ends and other control characters become blanks.
[[nodiscard]] std::string in_one_line(std::string_view text);
// At most as much of a value as a message shows.
[[nodiscard]] std::string shortened(std::string_view text);

// A finite decimal number, with or without a sign; nothing when the text is anything else.
[[nodiscard]] std::optional<double> number_of_text(std::string_view text);
[[nodiscard]] std::optional<int> whole_number_of_text(std::string_view text);

// The shortest text without an exponent that reads back to the same bits.
[[nodiscard]] std::string plain_number(double value);
[[nodiscard]] std::string fixed_number(double value, int decimals);

// Inches become mm on a grid of 1e-9 mm, so that 0.1 inch is 2.54 mm and not a bit less.
[[nodiscard]] double mm_of(double value, LengthUnit unit);
[[nodiscard]] double in_unit(double value_mm, LengthUnit unit);
[[nodiscard]] std::string_view name_of(LengthUnit unit);

}  // namespace stanok::jobs
