#include "client/offline/interpret/record_parts.h"

#include "base/utf8.h"

namespace stanok::client {

void append_string(std::string& text, std::string_view value) {
  text += '"';
  for (const char c : valid_utf8(value)) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      append(text, "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  text += '"';
}

void append_axes(std::string& text, const Words& words, const lang::AxisValues& point) {
  text += '{';
  for (std::size_t k = 0; k < words.size(); ++k) {
    append(text, R"({}"{}":{})", k == 0 ? "" : ",", words[k], point[k]);
  }
  text += '}';
}

}  // namespace stanok::client
