// Text of manual pages: roff with the macros of man(7).
#pragma once

#include <string>
#include <string_view>

namespace stanok::client::roff {

// The text as it is: nothing of it is taken for a request, an escape or a typographic sign.
[[nodiscard]] std::string escaped(std::string_view text);

[[nodiscard]] std::string bold(std::string_view text);
[[nodiscard]] std::string italic(std::string_view text);  // what the reader puts in

// .SH; the heading of a section.
[[nodiscard]] std::string section(std::string_view heading);
// .TP; `item` is roff already, `meaning` plain text below it.
[[nodiscard]] std::string described(std::string_view item, std::string_view meaning);

}  // namespace stanok::client::roff
