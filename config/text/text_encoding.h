// Texts of older controls and editors as UTF-8: CP1251, CP866, ISO-8859-1 and whatever else iconv
// of the system knows.
//
// Text that is UTF-8 already is left as it is, whatever the encoding that is named: a folder may
// hold both. A byte order mark of UTF-16 is believed before anything else. Bytes that the encoding
// does not have become U+FFFD. Source: iconv(3), POSIX.1-2017.
#pragma once

#include <string>
#include <string_view>

namespace stanok::config {

// Whether iconv has an encoding of this name, and letters, digits and signs of ASCII are themselves
// in it.
[[nodiscard]] bool is_encoding_of_programs(const std::string& name);

// `encoding`: of bytes that are neither UTF-8 nor marked as UTF-16; empty: they stay what they are.
[[nodiscard]] std::string text_from(std::string bytes, const std::string& encoding);

}  // namespace stanok::config
