// What a Modbus server must know of a request before libmodbus answers it: which registers it
// writes, and where a request ends on a serial line.
//
// Source: MODBUS Application Protocol V1.1b3, clauses 6.3, 6.6, 6.12, 6.17; MODBUS over Serial Line
// V1.02, clause 2.5.1 (RTU framing, CRC). libmodbus serves one unit id per serial context only, so
// the framing for many units stands here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace stanok::plant {

struct RegisterRange {
  int first = 0;
  int count = 0;

  [[nodiscard]] bool is_within(int size) const { return first + count <= size; }
};

// A request that writes holding registers: functions 6, 16 and 23.
struct RegisterWrite {
  int first = 0;
  std::vector<std::uint16_t> values{};
  RegisterRange read{};  // function 23 reads after it has written; else empty
};

// `pdu` begins with the function code. No value when the request writes no registers, or is
// malformed.
[[nodiscard]] std::optional<RegisterWrite> register_write(std::span<const std::uint8_t> pdu);

// CRC-16 of the serial line: polynomial A001h, begins with FFFFh.
[[nodiscard]] std::uint16_t crc16(std::span<const std::uint8_t> bytes);

// Cuts requests (unit id ... CRC) out of the bytes of a serial line. A silence on the line ends a
// request that is not complete: then `clear` is called.
class RtuRequestReader {
 public:
  void append(std::span<const std::uint8_t> bytes);
  void clear() { bytes_.clear(); }
  [[nodiscard]] bool is_empty() const { return bytes_.empty(); }

  // The next request with a good CRC; nothing when there is none yet. A bad CRC or an unknown
  // function discards all that has come.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> next();

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace stanok::plant
