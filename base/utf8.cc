#include "base/utf8.h"

#include <cstdint>
#include <cstring>

namespace stanok {
namespace {

// The first byte from `at` on that is not ASCII. Program texts are large and nearly always ASCII.
std::size_t behind_ascii(std::string_view text, std::size_t at) {
  constexpr std::uint64_t high_bits = 0x8080808080808080U;
  std::uint64_t bytes = 0;
  while (at + sizeof bytes <= text.size()) {
    std::memcpy(&bytes, text.data() + at, sizeof bytes);
    if ((bytes & high_bits) != 0) break;
    at += sizeof bytes;
  }
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80) ++at;
  return at;
}

// The first byte from `at` on that belongs to no character.
std::size_t behind_characters(std::string_view text, std::size_t at) {
  while ((at = behind_ascii(text, at)) < text.size()) {
    const std::size_t length = character_length(text, at);
    if (length == 0) break;
    at += length;
  }
  return at;
}

}  // namespace

bool is_utf8(std::string_view text) {
  return behind_characters(text, 0) == text.size();
}

std::string valid_utf8(std::string_view text) {
  std::string repaired;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bad = behind_characters(text, at);
    repaired += text.substr(at, bad - at);
    if (bad < text.size()) repaired += replacement_character;
    at = bad + 1;
  }
  return repaired;
}

std::size_t character_count(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += continues_character(c) ? 0 : 1;
  return count;
}

std::size_t offset_of_character(std::string_view text, std::size_t character) {
  std::size_t at = 0;
  for (std::size_t count = 0; at < text.size(); ++at) {
    if (!continues_character(text[at]) && count++ == character) break;
  }
  return at;
}

}  // namespace stanok
