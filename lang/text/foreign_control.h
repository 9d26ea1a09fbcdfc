// Programs for controls whose language is no ISO 6983 text, or one with words of its own: Siemens,
// Heidenhain, Okuma.
//
// A text is told from its first line, or from a faulty line with words that only such a control
// has.
#pragma once

#include <string_view>

namespace stanok::lang {

// The control for which a text is written, by its first line; empty: nothing points to one.
[[nodiscard]] std::string_view control_of_header(std::string_view text);

// The control that has the words of this line; empty: none is known.
[[nodiscard]] std::string_view control_of_line(std::string_view line);

}  // namespace stanok::lang
