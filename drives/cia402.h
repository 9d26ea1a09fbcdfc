// Codes of the power drive system of CiA 402: status word to state, and the control word that leads
// from a state to where the master wants the drive.
//
// Source: CiA 402 part 2 / IEC 61800-7-201: objects 6040h (control word), 6041h (status word),
// 603Fh (error code). The bits that these leave to the manufacturer stand in drives/register_map.h.
#pragma once

#include <cstdint>
#include <optional>

#include "base/rt_safe.h"
#include "drives/drive.h"

namespace stanok::drives {

namespace control {
inline constexpr std::uint16_t switch_on = 1U << 0;
inline constexpr std::uint16_t enable_voltage = 1U << 1;
inline constexpr std::uint16_t no_quick_stop = 1U << 2;  // the bit is low-active
inline constexpr std::uint16_t enable_operation = 1U << 3;
inline constexpr std::uint16_t fault_reset = 1U << 7;
}  // namespace control

namespace status {
inline constexpr std::uint16_t voltage_enabled = 1U << 4;
inline constexpr std::uint16_t remote = 1U << 9;
inline constexpr std::uint16_t follows_target = 1U << 12;
inline constexpr std::uint16_t following_error = 1U << 13;
}  // namespace status

namespace fault_code {
inline constexpr std::uint16_t over_current = 0x2310;
inline constexpr std::uint16_t communication_lost = 0x8130;
inline constexpr std::uint16_t following_error = 0x8611;
}  // namespace fault_code

// No value when the bits are no state of the standard: the word is not to be trusted.
[[nodiscard]] std::optional<DriveState> state_of(std::uint16_t status_word) RT_SAFE;

// The state bits of the status word (bits 0..3, 5, 6).
[[nodiscard]] std::uint16_t state_bits(DriveState state) RT_SAFE;

// What the master wants of a drive.
enum class PowerRequest : std::uint8_t { off, on, quick_stop, reset_fault };

// The control word that brings a drive in `state` one transition nearer to the request.
[[nodiscard]] std::uint16_t control_word(DriveState state, PowerRequest request) RT_SAFE;

}  // namespace stanok::drives
