// Where a drive keeps what it is told and what it is asked: one field of holding registers for
// every quantity.
//
// A field says address, width, order of words, and how increments become units: increments =
// value * scale + offset. A drive that lacks a quantity has no field for it. The standard map is
// docs/integrator/drives.md#registers; the maps of other drives come from the machine file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/place.h"
#include "base/rt_safe.h"

namespace stanok::drives {

// Which of the two registers of a 32-bit value comes first.
enum class WordOrder : std::uint8_t { high_first, low_first };

struct RegisterField {
  static constexpr int absent = -1;

  int address = absent;    // of the first register
  int words = 1;           // 1: 16 bits, 2: 32 bits
  bool is_signed = false;  // two's complement; 32 bits always are
  WordOrder order = WordOrder::high_first;
  double scale = 1.0;   // increments per unit, not 0
  double offset = 0.0;  // increments at 0

  [[nodiscard]] bool exists() const RT_SAFE { return address != absent; }
  // Of the first register in an image that begins with register 0; the field must exist.
  [[nodiscard]] std::size_t place() const RT_SAFE { return place_of(address); }
  [[nodiscard]] int end() const RT_SAFE { return address + words; }

  [[nodiscard]] double value(std::int32_t increments) const RT_SAFE {
    return (increments - offset) / scale;
  }
  // The nearest number of increments; no value when it is not a number or too long for the field;
  // 0 when the drive has no such field.
  [[nodiscard]] std::optional<std::int32_t> increments(double value) const RT_SAFE;
  // The same, with the end of the range for what lies beyond it, and 0 for what is no number.
  [[nodiscard]] std::int32_t saturated_increments(double value) const RT_SAFE;

  bool operator==(const RegisterField&) const = default;
};

// Bits that the standards leave to the manufacturer, as masks; 0: the drive has none.
struct DriveBits {
  // Bits of the control word.
  std::uint16_t close_brake = 0;
  std::uint16_t follow_velocity = 0;
  // Bits of the status word.
  std::uint16_t brake_closed = 0;
  std::uint16_t referenced = 0;
  // Bits of the register `inputs`.
  std::uint16_t limit_negative = 0;
  std::uint16_t limit_positive = 0;
  std::uint16_t home_switch = 0;

  bool operator==(const DriveBits&) const = default;
};

// The bits of the simulated drives; the switches are those of object 60FDh of CiA 402.
inline constexpr DriveBits standard_bits{.close_brake = 1U << 11,
                                         .follow_velocity = 1U << 12,
                                         .brake_closed = 1U << 14,
                                         .referenced = 1U << 15,
                                         .limit_negative = 1U << 0,
                                         .limit_positive = 1U << 1,
                                         .home_switch = 1U << 2};

struct RegisterMap {
  // Written.
  RegisterField control_word;
  RegisterField target_position;  // mm, deg
  RegisterField target_velocity;  // mm/s, deg/s; rev/min of a spindle
  RegisterField heartbeat;        // changes with every exchange

  // Read.
  RegisterField status_word;
  RegisterField position;
  RegisterField velocity;
  RegisterField following_error;
  RegisterField power;                // W
  RegisterField vibration;            // um
  RegisterField vibration_frequency;  // Hz
  RegisterField fault_code;
  RegisterField heartbeat_echo;
  RegisterField inputs;
  RegisterField index_position;  // where the last index pulse was, mm or deg
  RegisterField index_count;     // of index pulses so far
  RegisterField temperature;     // deg C

  DriveBits bits;

  bool operator==(const RegisterMap&) const = default;
};

using FieldOfMap = RegisterField RegisterMap::*;

inline constexpr std::array<FieldOfMap, 4> written_fields = {
    &RegisterMap::control_word, &RegisterMap::target_position, &RegisterMap::target_velocity,
    &RegisterMap::heartbeat};

inline constexpr std::array<FieldOfMap, 13> read_fields = {&RegisterMap::status_word,
                                                           &RegisterMap::position,
                                                           &RegisterMap::velocity,
                                                           &RegisterMap::following_error,
                                                           &RegisterMap::power,
                                                           &RegisterMap::vibration,
                                                           &RegisterMap::vibration_frequency,
                                                           &RegisterMap::fault_code,
                                                           &RegisterMap::heartbeat_echo,
                                                           &RegisterMap::inputs,
                                                           &RegisterMap::index_position,
                                                           &RegisterMap::index_count,
                                                           &RegisterMap::temperature};

// Where the two blocks of the standard map begin, and its scales.
struct StandardMap {
  int control = 0;
  int status = 100;
  double position_scale = 1000.0;  // increments per mm or deg
  double velocity_scale = 1000.0;  // increments/s per mm/s or deg/s
};

[[nodiscard]] RegisterMap register_map(const StandardMap& standard);

// One more than the highest register that the map uses.
[[nodiscard]] int register_count(const RegisterMap& map);

// Image of the registers of a drive: register n at place n. The field must lie within it.
[[nodiscard]] std::int32_t read_field(const RegisterField& field,
                                      std::span<const std::uint16_t> image) RT_SAFE;
void write_field(const RegisterField& field, std::int32_t increments,
                 std::span<std::uint16_t> image) RT_SAFE;

}  // namespace stanok::drives
