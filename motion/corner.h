// What becomes of the join between two blocks: passed as it is, blended, or a stop.
#pragma once

#include "motion/path.h"

namespace stanok::motion {

enum class Join : std::uint8_t {
  smooth,  // tangent and curvature continue in all axes: the path passes as it is
  corner,  // to be blended
  turn,    // the path turns back on itself, or changes its metric: the axes must stop
};

// Judges the join at which `incoming` ends and `outgoing` starts.
[[nodiscard]] Join judge_join(const Piece& incoming, const Piece& outgoing);

}  // namespace stanok::motion
