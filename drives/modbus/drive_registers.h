// What is written to a drive and what is read from it in one exchange, in increments, and the way
// between these blocks and the registers of its map.
//
// Drive and master use the same functions, so the map stands in one place. What a map does not have
// is not written, and reads as 0.
#pragma once

#include <cstdint>
#include <span>

#include "base/rt_safe.h"
#include "drives/register_map.h"

namespace stanok::drives {

struct CommandBlock {
  std::uint16_t control_word = 0;
  std::int32_t target_position = 0;
  std::int32_t target_velocity = 0;
  std::uint16_t heartbeat = 0;  // changes with every exchange; the drive echoes it

  bool operator==(const CommandBlock&) const = default;
};

struct StatusBlock {
  std::uint16_t status_word = 0;
  std::int32_t position = 0;
  std::int32_t velocity = 0;
  std::int32_t following_error = 0;  // demand of the drive minus position
  std::int32_t power = 0;
  std::int32_t vibration = 0;  // amplitude
  std::int32_t vibration_frequency = 0;
  std::uint16_t fault_code = 0;
  std::uint16_t heartbeat_echo = 0;
  std::uint16_t inputs = 0;
  std::int32_t index_position = 0;
  std::uint16_t index_count = 0;
  std::int32_t temperature = 0;

  bool operator==(const StatusBlock&) const = default;
};

// `image` holds register n at place n and reaches to register_count(map).
void write_block(const RegisterMap& map, const CommandBlock& block, std::span<std::uint16_t> image)
    RT_SAFE;
void write_block(const RegisterMap& map, const StatusBlock& block, std::span<std::uint16_t> image)
    RT_SAFE;

[[nodiscard]] CommandBlock command_block(const RegisterMap& map,
                                         std::span<const std::uint16_t> image) RT_SAFE;
[[nodiscard]] StatusBlock status_block(const RegisterMap& map, std::span<const std::uint16_t> image)
    RT_SAFE;

}  // namespace stanok::drives
