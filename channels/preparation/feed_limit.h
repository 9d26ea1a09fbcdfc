// The feed that the axes can reach along a block: what lies above is limited, with one warning, and
// a tap that needs more is refused.
#pragma once

#include <optional>

#include "base/diagnostic.h"
#include "motion/path/path.h"

namespace stanok::channels {

// Says that the feed of a segment is above what the speeds of the axes allow along it (W810), or
// nothing. The place of the diagnostic is left open.
[[nodiscard]] std::optional<Diagnostic> feed_above_limit(const motion::Segment& segment,
                                                         const motion::MotionConfig& motion);

// Why the axes cannot tap along this line from `start` with the feed of the block, which the lead
// and the spindle give (E5302); `geometry`: axes that are X, Y, Z.
[[nodiscard]] std::optional<Diagnostic> tap_refusal(const motion::PathBlock& line,
                                                    const motion::Point& start,
                                                    const std::array<int, 3>& geometry,
                                                    const motion::MotionConfig& motion);

}  // namespace stanok::channels
