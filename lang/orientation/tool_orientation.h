// Directions of the tool that blocks want, and the rotary axes that give them: G53.1 and G53.6
// along the normal of a plane, G43.5 along a vector, #orientation (vector) along a great circle.
//
// The channel answers where its axes would have to stand (contract/tool_alignment.h); what it
// cannot reach fails the block here, with axis, limit and the nearest direction.
#pragma once

#include <optional>
#include <string_view>

#include "lang/block/active_block.h"
#include "lang/contract/tool_alignment.h"

namespace stanok::lang {

// The letters of a vector of the tool beside G0 and G1.
inline constexpr LetterSet vector_letters = letters_of("IJK");

// What a block wants, for its messages.
struct OrientationWish {
  WordName word;            // that wants it
  std::string_view name{};  // of what wants it; empty: the word, a G code
  Direction tool_B{0.0, 0.0, 1.0};
  FirstRotary first = FirstRotary::nearest;
  std::string_view purpose;     // "align the tool with the plane, whose normal is"
  Group said_by = Group::none;  // code that brought the direction, for a note
  std::string_view remedy;
  std::string_view end{};  // of a way to it: "this tool vector"
};

// Angles of the rotary axes, from where the block begins; nothing: the block has failed.
[[nodiscard]] std::optional<Alignment> reachable_angles(ActiveBlock& block,
                                                        const OrientationWish& wish);
// The same from where the axes stand in B.
[[nodiscard]] std::optional<Alignment> reachable_angles(ActiveBlock& block,
                                                        const OrientationWish& wish,
                                                        const AxisValues& from_B);

// I, J and K of the block as a direction from the tip into the spindle, in the frame of the
// programmed coordinates and with any length above 0; nothing: the block has failed (E4355).
[[nodiscard]] std::optional<Direction> vector_of_block(ActiveBlock& block);

}  // namespace stanok::lang
