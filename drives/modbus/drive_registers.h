// The two register blocks of a drive: what the master writes and what it reads in one exchange.
//
// Registers are 16 bits; 32-bit values are two's complement over two registers, high word first.
// The map is docs/drives.md#registers. Drive and master use the same functions, so the map stands
// in one place.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/rt_safe.h"

namespace stanok::drives {

// Written block, from AxisDriveConfig::control_register on.
struct CommandBlock {
  std::uint16_t control_word = 0;
  std::int32_t target_position = 0;  // increments
  std::int32_t target_velocity = 0;  // increments/s
  std::uint16_t heartbeat = 0;       // changes with every exchange; the drive echoes it

  bool operator==(const CommandBlock&) const = default;
};
inline constexpr int command_register_count = 6;
using CommandRegisters = std::array<std::uint16_t, command_register_count>;

// Read block, from AxisDriveConfig::status_register on.
struct StatusBlock {
  std::uint16_t status_word = 0;
  std::int32_t position = 0;         // increments
  std::int32_t velocity = 0;         // increments/s
  std::int32_t following_error = 0;  // increments, demand of the drive minus position
  std::int16_t power_w = 0;
  std::uint16_t vibration = 0;            // amplitude in 0.1 um
  std::uint16_t vibration_frequency = 0;  // 0.1 Hz
  std::uint16_t fault_code = 0;
  std::uint16_t heartbeat_echo = 0;

  bool operator==(const StatusBlock&) const = default;
};
inline constexpr int status_register_count = 12;
using StatusRegisters = std::array<std::uint16_t, status_register_count>;

[[nodiscard]] CommandRegisters to_registers(const CommandBlock& block) RT_SAFE;
[[nodiscard]] CommandBlock command_block(
    std::span<const std::uint16_t, command_register_count> registers) RT_SAFE;

[[nodiscard]] StatusRegisters to_registers(const StatusBlock& block) RT_SAFE;
[[nodiscard]] StatusBlock status_block(
    std::span<const std::uint16_t, status_register_count> registers) RT_SAFE;

// The nearest integer number of increments; no value when it is not a number or needs more than 32
// bits.
[[nodiscard]] std::optional<std::int32_t> increments(double value, double scale) RT_SAFE;

}  // namespace stanok::drives
