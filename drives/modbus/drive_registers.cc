// Packing of the register blocks with shifts and bit casts: no word order but the one written here.
#include "drives/modbus/drive_registers.h"

#include <bit>
#include <cmath>
#include <limits>

namespace stanok::drives {
namespace {

constexpr std::uint16_t high_word(std::int32_t value) RT_SAFE {
  return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(value) >> 16U);
}

constexpr std::uint16_t low_word(std::int32_t value) RT_SAFE {
  return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(value) & 0xFFFFU);
}

constexpr std::int32_t joined(std::uint16_t high, std::uint16_t low) RT_SAFE {
  return std::bit_cast<std::int32_t>((static_cast<std::uint32_t>(high) << 16U) | low);
}

}  // namespace

CommandRegisters to_registers(const CommandBlock& block) RT_SAFE {
  return {block.control_word,
          high_word(block.target_position),
          low_word(block.target_position),
          high_word(block.target_velocity),
          low_word(block.target_velocity),
          block.heartbeat};
}

CommandBlock command_block(std::span<const std::uint16_t, command_register_count> registers)
    RT_SAFE {
  return {.control_word = registers[0],
          .target_position = joined(registers[1], registers[2]),
          .target_velocity = joined(registers[3], registers[4]),
          .heartbeat = registers[5]};
}

StatusRegisters to_registers(const StatusBlock& block) RT_SAFE {
  return {block.status_word,
          high_word(block.position),
          low_word(block.position),
          high_word(block.velocity),
          low_word(block.velocity),
          high_word(block.following_error),
          low_word(block.following_error),
          std::bit_cast<std::uint16_t>(block.power_w),
          block.vibration,
          block.vibration_frequency,
          block.fault_code,
          block.heartbeat_echo};
}

StatusBlock status_block(std::span<const std::uint16_t, status_register_count> registers) RT_SAFE {
  return {.status_word = registers[0],
          .position = joined(registers[1], registers[2]),
          .velocity = joined(registers[3], registers[4]),
          .following_error = joined(registers[5], registers[6]),
          .power_w = std::bit_cast<std::int16_t>(registers[7]),
          .vibration = registers[8],
          .vibration_frequency = registers[9],
          .fault_code = registers[10],
          .heartbeat_echo = registers[11]};
}

std::optional<std::int32_t> increments(double value, double scale) RT_SAFE {
  const double rounded = std::round(value * scale);
  constexpr double limit = std::numeric_limits<std::int32_t>::max();
  if (!(std::fabs(rounded) <= limit)) {
    return std::nullopt;
  }
  return static_cast<std::int32_t>(rounded);
}

}  // namespace stanok::drives
