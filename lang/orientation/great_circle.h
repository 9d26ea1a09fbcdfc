// The way of the tool from one direction to another: in the plane of both, along the great circle,
// while rotary axes that moved evenly would swing it aside, near a pole by far.
//
// A move is divided into parts at whose ends the rotary axes stand exactly on the circle; within
// each they move evenly, and the tool is off the circle by less than a tolerance. Where parts meet
// the path is rounded less than elsewhere; the first and the last part are short, and are rounded
// like any other path towards the moves beside them. The axes go on from part to part the nearest
// way, so that they stay in one branch as long as the travel allows it.
#pragma once

#include <optional>
#include <vector>

#include "lang/block/active_block.h"
#include "lang/contract/tool_alignment.h"
#include "lang/orientation/tool_orientation.h"

namespace stanok::lang {

// How far a rotary axis may leave its parts where they are rounded. The tool swings by less: by up
// to 0.0038 deg on 1,000 random moves of each chain (tests/runtime/great_circle_test.cc).
inline constexpr double part_rounding_deg = 0.005;

// Where a part of a move ends.
struct TurnedPart {
  double part = 1.0;  // of the move
  Alignment alignment;
};

// To the direction of `wish` from where the block begins; the last part ends there. Vectors that
// are opposite have no plane: one part. Nothing: the block has failed (E4353, E4354), also where
// the axes would have to change to their other branch on the way.
[[nodiscard]] std::optional<std::vector<TurnedPart>> great_circle(ActiveBlock& block,
                                                                  const OrientationWish& wish);
// The same to where the axes stand at `end_B`, at whose angles the last part ends.
[[nodiscard]] std::optional<std::vector<TurnedPart>> great_circle(ActiveBlock& block,
                                                                  const OrientationWish& wish,
                                                                  const AxisValues& end_B);

}  // namespace stanok::lang
