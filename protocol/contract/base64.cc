#include "protocol/contract/base64.h"

#include <cstdint>

namespace stanok::protocol {

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t group = 3;
  std::string text;
  text.reserve((bytes.size() + group - 1) / group * 4);
  for (std::size_t at = 0; at < bytes.size(); at += group) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < group; ++k) {
      const std::size_t place = at + k;
      word = word << 8U | (place < bytes.size() ? static_cast<std::uint8_t>(bytes[place]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool has_bits = at + k <= bytes.size();
      text += has_bits ? letters[word >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace stanok::protocol
