// The state table of CiA 402 and the way of a master through it.
#include "drives/cia402.h"

#include <array>

#include "base/enum_array.h"

namespace stanok::drives {
namespace {

// Status word patterns of object 6041h.
struct StatePattern {
  DriveState state;
  std::uint16_t mask;
  std::uint16_t bits;
  std::string_view name;
};

constexpr EnumArray<DriveState, StatePattern> patterns = {{{
    {DriveState::not_ready_to_switch_on, 0x4F, 0x00, "not ready to switch on"},
    {DriveState::switch_on_disabled, 0x4F, 0x40, "switch on disabled"},
    {DriveState::ready_to_switch_on, 0x6F, 0x21, "ready to switch on"},
    {DriveState::switched_on, 0x6F, 0x23, "switched on"},
    {DriveState::operation_enabled, 0x6F, 0x27, "operation enabled"},
    {DriveState::quick_stop_active, 0x6F, 0x07, "quick stop active"},
    {DriveState::fault_reaction_active, 0x4F, 0x0F, "fault reaction active"},
    {DriveState::fault, 0x4F, 0x08, "fault"},
}}};

constexpr std::uint16_t disable_voltage = 0;
constexpr std::uint16_t quick_stop = control::enable_voltage;
constexpr std::uint16_t shutdown = control::enable_voltage | control::no_quick_stop;
constexpr std::uint16_t switch_on = shutdown | control::switch_on;
constexpr std::uint16_t enable_operation = switch_on | control::enable_operation;

std::uint16_t word_towards_on(DriveState state) RT_SAFE {
  switch (state) {
    case DriveState::ready_to_switch_on:
      return switch_on;
    case DriveState::switched_on:
    case DriveState::operation_enabled:
      return enable_operation;
    case DriveState::quick_stop_active:
      return quick_stop;
    default:
      return shutdown;
  }
}

}  // namespace

std::string_view name_of(DriveState state) {
  return patterns[state].name;
}

std::optional<DriveState> state_of(std::uint16_t status_word) RT_SAFE {
  for (const StatePattern& pattern : patterns) {
    if ((status_word & pattern.mask) == pattern.bits) {
      return pattern.state;
    }
  }
  return std::nullopt;
}

std::uint16_t state_bits(DriveState state) RT_SAFE {
  return patterns[state].bits;
}

std::uint16_t control_word(DriveState state, PowerRequest request) RT_SAFE {
  switch (request) {
    case PowerRequest::on:
      return word_towards_on(state);
    case PowerRequest::quick_stop:
      return quick_stop;
    case PowerRequest::reset_fault:
      return control::fault_reset;
    case PowerRequest::off:
      break;
  }
  return state == DriveState::quick_stop_active ? disable_voltage : shutdown;
}

}  // namespace stanok::drives
