// Layout of the requests with function codes 1 to 6, 15, 16, 22 and 23.
#include "plant/modbus/modbus_request.h"

#include <algorithm>

namespace stanok::plant {
namespace {

constexpr std::uint8_t write_single_register = 6;
constexpr std::uint8_t write_multiple_coils = 15;
constexpr std::uint8_t write_multiple_registers = 16;
constexpr std::uint8_t mask_write_register = 22;
constexpr std::uint8_t write_and_read_registers = 23;

int word_at(std::span<const std::uint8_t> bytes, std::size_t place) {
  return bytes[place] << 8 | bytes[place + 1];
}

// Values that follow their byte count at `place`.
std::optional<std::vector<std::uint16_t>> counted_values(std::span<const std::uint8_t> pdu,
                                                         std::size_t place) {
  if (pdu.size() <= place || pdu.size() != place + 1 + pdu[place] || pdu[place] % 2 != 0) {
    return std::nullopt;
  }
  std::vector<std::uint16_t> values;
  for (std::size_t at = place + 1; at < pdu.size(); at += 2) {
    values.push_back(static_cast<std::uint16_t>(word_at(pdu, at)));
  }
  return values;
}

// Length of a serial request with unit id and CRC; 0: not yet known; no value: unknown function.
std::optional<std::size_t> frame_length(std::span<const std::uint8_t> frame) {
  constexpr std::size_t unit_and_crc = 3;
  const auto counted = [&](std::size_t count_place) {
    return frame.size() <= count_place ? 0 : count_place + 1 + frame[count_place] + 2;
  };
  if (frame.size() < 2) {
    return 0;
  }
  switch (frame[1]) {
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
    case write_single_register:
      return unit_and_crc + 5;
    case write_multiple_coils:
    case write_multiple_registers:
      return counted(6);
    case mask_write_register:
      return unit_and_crc + 7;
    case write_and_read_registers:
      return counted(10);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<RegisterWrite> register_write(std::span<const std::uint8_t> pdu) {
  if (pdu.size() < 5) {
    return std::nullopt;
  }
  RegisterWrite write{.first = word_at(pdu, 1)};
  if (pdu[0] == write_single_register) {
    write.values = {static_cast<std::uint16_t>(word_at(pdu, 3))};
    return write;
  }
  std::optional<std::vector<std::uint16_t>> values;
  if (pdu[0] == write_multiple_registers) {
    values = counted_values(pdu, 5);
  } else if (pdu[0] == write_and_read_registers) {
    values = counted_values(pdu, 9);
  }
  if (!values) {
    return std::nullopt;
  }
  if (pdu[0] == write_and_read_registers) {
    write.read = {.first = word_at(pdu, 1), .count = word_at(pdu, 3)};
    write.first = word_at(pdu, 5);
  }
  write.values = std::move(*values);
  return write;
}

std::uint16_t crc16(std::span<const std::uint8_t> bytes) {
  unsigned crc = 0xFFFFU;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xA001U : crc >> 1U;
    }
  }
  return static_cast<std::uint16_t>(crc);
}

void RtuRequestReader::append(std::span<const std::uint8_t> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<std::vector<std::uint8_t>> RtuRequestReader::next() {
  const std::optional<std::size_t> length = frame_length(bytes_);
  if (length && (*length == 0 || bytes_.size() < *length)) {
    return std::nullopt;
  }
  // Over a whole frame with its CRC, low byte first, the CRC is 0.
  if (!length || crc16(std::span(bytes_).first(*length)) != 0) {
    clear();
    return std::nullopt;
  }
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(*length);
  std::vector<std::uint8_t> frame(bytes_.begin(), end);
  bytes_.erase(bytes_.begin(), end);
  return frame;
}

}  // namespace stanok::plant
