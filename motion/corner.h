// What becomes of the join between two blocks: passed as it is, blended, or a stop.
//
// Which of the last two is faster depends on the limits: a blend saves the full stop but must be
// passed slowly over its whole length. docs/motion.md#blends.
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

// Whether the axes come through sooner when they stop at the corner instead of taking `blend`,
// whose bounds are known. Ramps are counted at the limits of either block, within half of its
// length.
[[nodiscard]] bool is_stop_faster(const Piece& incoming, const Piece& blend, const Piece& outgoing,
                                  const MotionConfig& config);

}  // namespace stanok::motion
