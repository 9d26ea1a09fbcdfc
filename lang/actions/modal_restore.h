// Brings a channel back to a modal state that was saved, without motion and without a tool change.
#pragma once

#include "lang/block/active_block.h"

namespace stanok::lang {

// Parts of the modal state; the first six are the GV_* constants of programs.
using StateParts = unsigned;
inline constexpr StateParts state_modal = 1;     // G codes but those of other parts, M48 M49
inline constexpr StateParts state_feed = 2;      // F, the feed law
inline constexpr StateParts state_spindle = 4;   // S, M3 M4 M5, G96 G97
inline constexpr StateParts state_tool = 8;      // T, tool length, overhang
inline constexpr StateParts state_frames = 16;   // G52, G92, rotation, scaling, mirror
inline constexpr StateParts state_coolant = 32;  // M7 M8 M9
inline constexpr StateParts state_all = 63;
// Within state_modal and state_tool; GV_* always takes them along.
inline constexpr StateParts state_motion = 64;   // G0, G1, ...
inline constexpr StateParts state_length = 128;  // G43, G49, without T

// What M70 saves: as LinuxCNC neither the motion code nor T nor shifts.
inline constexpr StateParts state_of_m70 =
    state_modal | state_feed | state_spindle | state_coolant | state_length;

// Why the parts of `saved` cannot be restored here; empty when they can.
[[nodiscard]] std::string_view reason_against_restoring(const ModalState& now,
                                                        const ModalState& saved, StateParts parts);
// Restores them; what the machine must follow goes into block.queue. There must be no reason
// against it.
void restore_state(ActiveBlock& block, const ModalState& saved, StateParts parts);

}  // namespace stanok::lang
