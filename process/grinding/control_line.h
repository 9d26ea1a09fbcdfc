// Lines of a control file: numbers and the text around them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "process/grinding/control_file.h"

namespace stanok::process {

// The text in lines, their ends kept in the last part of `between`. At most `numbers_max` numbers
// at the beginning of a line are numbers; the rest is label.
[[nodiscard]] ControlLine split_line(std::string_view line, int numbers_max);
[[nodiscard]] std::vector<std::string_view> lines_of(std::string_view text);
[[nodiscard]] bool is_blank(std::string_view line);

// The line with other values; a number whose value is the same keeps its digits, another one takes
// at least as many decimals.
[[nodiscard]] std::string line_text(const ControlLine& line, const std::vector<double>& values);

// The value of a number's text; not finite when it is none.
[[nodiscard]] double value_of(std::string_view number);

}  // namespace stanok::process
