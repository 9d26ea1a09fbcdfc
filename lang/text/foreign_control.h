// Texts for controls whose language is no ISO 6983 text, or one with words of its own: Siemens,
// Heidenhain, Okuma, ISG, Eding; for 3-D printers; and CL data, which is no program at all.
//
// A text is told from its first line, or from a faulty line with words that only such a text has.
#pragma once

#include <string_view>

namespace stanok::lang {

struct ForeignText {
  std::string_view what;    // behind "this looks like "
  std::string_view remedy;  // what to do with it
};

// What a text looks like, by its first line; nullptr: nothing points to a foreign one.
[[nodiscard]] const ForeignText* foreign_by_header(std::string_view text);

// What has words as those of this line; nullptr: none is known.
[[nodiscard]] const ForeignText* foreign_by_line(std::string_view line);

}  // namespace stanok::lang
