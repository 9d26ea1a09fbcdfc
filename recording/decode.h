// Messages from the bytes of a log or of the bus.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace stanok::recording {

// Nothing when the bytes are not exactly one message of that type.
template <class Message>
[[nodiscard]] std::optional<Message> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > std::numeric_limits<int>::max()) return std::nullopt;
  Message message;
  const int size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) return std::nullopt;
  return message;
}

}  // namespace stanok::recording
