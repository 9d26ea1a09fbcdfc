#include "jobs/npz/npy_texts.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/utf8.h"

namespace stanok::jobs {
namespace {

// Of a whole character of UTF-8.
char32_t code_point(std::string_view character) {
  constexpr unsigned lead_bits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t code = static_cast<unsigned char>(character[0]) & lead_bits[character.size()];
  for (const char byte : character.substr(1))
    code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
  return code;
}

std::u32string characters_of(const std::string& text) {
  std::u32string characters;
  const std::string valid = valid_utf8(text);
  for (std::size_t at = 0; at < valid.size();) {
    const std::size_t length = character_length(valid, at);
    characters += code_point(std::string_view(valid).substr(at, length));
    at += length;
  }
  return characters;
}

}  // namespace

NpyTexts npy_texts(std::string name, const std::vector<std::string>& texts) {
  std::vector<std::u32string> rows;
  std::size_t longest = 1;  // NumPy has no text of no character
  for (const std::string& text : texts)
    longest = std::max(longest, rows.emplace_back(characters_of(text)).size());
  std::string bytes;
  for (std::u32string& row : rows) {
    row.resize(longest);
    for (const char32_t character : row) {
      for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(character >> shift & 0xFFU);
    }
  }
  const auto width = static_cast<std::int64_t>(longest);
  return {{.name = std::move(name),
           .type = "<U" + std::to_string(longest),
           .item_bytes = 4 * width,
           .shape = {static_cast<std::int64_t>(texts.size())}},
          std::move(bytes)};
}

}  // namespace stanok::jobs
