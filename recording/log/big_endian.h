// Numbers of LCM's files and messages: their most significant byte comes first.
#pragma once

#include <cstdint>
#include <span>

namespace stanok::recording {

// Of at most 8 bytes.
[[nodiscard]] inline std::uint64_t big_endian(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8U | byte;
  return value;
}

}  // namespace stanok::recording
