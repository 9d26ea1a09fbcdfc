// Command rules: what an operator may ask of a channel in which situation, and with which code the
// others are refused: one table.
//
// Which rule an action has says its row (channels/contract/operator_action.h). The coordinator asks
// the table when a command arrives, docs/operator/at-the-machine.md prints it, and a
// test drives a daemon through every cell of it. A command that is admitted may still fail for
// reasons of its own: an axis that does not exist or is not homed, drives that are not ready.
#pragma once

#include <string_view>

#include "base/enum_array.h"
#include "base/rt_safe.h"
#include "channels/contract/operator_event.h"

namespace stanok::channels {

// What a channel is doing, as far as commands depend on it; the first one that holds, from below.
enum class Situation : std::uint8_t {
  off,        // without power
  idle,       // on, no program loaded
  ready,      // on, a program loaded
  by_hand,    // on, axes being jogged or homed
  switching,  // on, an operator's change of kinematics under way
  running,
  held,
  aside,   // held, with axes moved away from the path by hand
  alarm,   // the alarm of a program; power stays on
  fault,   // the alarm of a fault or an emergency stop; without power
  ending,  // coming to rest for a stop, a reset or a fault
};

inline constexpr auto situations = enum_values<Situation>();

// "by hand"
[[nodiscard]] std::string_view name_of(Situation situation);

// The code of the catalogue with which a channel in this situation refuses the action; empty: it
// is admitted.
[[nodiscard]] std::string_view refusal_code(OperatorAction action, Situation situation) RT_SAFE;

// What the codes of the table say of a channel: " is running or held".
[[nodiscard]] std::string_view claim_of_refusal(std::string_view code) RT_SAFE;

// What is refused while another session has a channel to itself (docs/operator/at-the-machine.md).
enum class ControlScope : std::uint8_t {
  nothing,       // stops pass always
  channel,       // what concerns that channel
  all_channels,  // what concerns the machine or its tables: one such channel is enough
};
[[nodiscard]] ControlScope control_scope(OperatorAction action) RT_SAFE;

// Whether all channels must admit the action: it concerns the machine or its tables.
[[nodiscard]] bool concerns_all_channels(OperatorAction action) RT_SAFE;

}  // namespace stanok::channels
