// Faults that can be injected into a simulated drive, by name or by the number on the fault panel.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace stanok::plant {

// The numbers are the values of the panel's registers (docs/integrator/drives.md#faults).
enum class FaultKind : std::uint16_t {
  none = 0,
  off = 1,           // without power: no answer; the axis runs out into its brake
  stuck = 2,         // answers, but for ever with the same values
  garbage = 3,       // answers with arbitrary values
  slow = 4,          // answers too late
  intermittent = 5,  // loses one request in five
  trip = 6,          // over-current fault of the drive, once
  elsewhere = 7,     // as off, and comes back with another position
  mangled = 8,       // answers with broken frames
  hang_up = 9,       // closes the connection instead of answering
  jammed = 10,       // the axis does not move, whatever the motor does
  frozen = 11,       // answers rightly, but with the same position for ever and no following error
};
inline constexpr std::uint16_t fault_kind_count = 12;

[[nodiscard]] std::string_view name_of(FaultKind kind);
[[nodiscard]] std::optional<FaultKind> fault_named(std::string_view name);

}  // namespace stanok::plant
