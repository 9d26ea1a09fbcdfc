// Messages from the bytes of a log or of the bus.
#pragma once

#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>

namespace stanok::recording {

// The cycle that every message of ours has behind its fingerprint and utime; 0 of none of ours.
[[nodiscard]] inline std::int64_t cycle_of(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t offset = 16;
  if (bytes.size() < offset + sizeof(std::uint64_t)) return 0;
  std::uint64_t cycle = 0;
  for (const std::uint8_t byte : bytes.subspan(offset, sizeof cycle)) cycle = cycle << 8U | byte;
  return static_cast<std::int64_t>(cycle);
}

// Nothing when the bytes are not exactly one message of that type. The decoders of LCM throw where
// a string claims to have no byte, not even its end, and where an array claims more than there is
// memory for.
template <class Message>
[[nodiscard]] std::optional<Message> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > std::numeric_limits<int>::max()) return std::nullopt;
  Message message{};
  const int size = static_cast<int>(bytes.size());
  try {
    if (message.decode(bytes.data(), 0, size) != size) return std::nullopt;
  } catch (const std::length_error&) {
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
  return message;
}

}  // namespace stanok::recording
