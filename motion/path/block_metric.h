// What a programmed block moves, and what its path coordinate counts.
//
// The one place that says when a block moves at all, and whether its feed is one along the tip's
// way in mm or one of rotary axes in deg: the feed of a block and the segments made of it follow
// the same answer.
#pragma once

#include "motion/path/path.h"

namespace stanok::motion {

// Positions closer than this (mm or deg) are the same: far below every resolution, far above the
// rounding of sums of offsets. The language takes coordinates for equal within it, too.
inline constexpr double standstill = 1e-9;

enum class BlockTravel {
  none,      // nothing moves
  geometry,  // s counts the tip's path in mm
  others     // X, Y and Z stand: s counts the distance of all other axes
};

// A block from `start`; arcs and curves whose length is shorter than `standstill` count as lines.
[[nodiscard]] BlockTravel travel_of(const PathBlock& block, const Point& start,
                                    const MotionConfig& config);

[[nodiscard]] PathMetric metric_of(BlockTravel travel, const MotionConfig& config);

// Length of the block in mm, or in deg where only other axes move; 0 where nothing does.
[[nodiscard]] double length_of(const PathBlock& block, const Point& start,
                               const MotionConfig& config);

// The arc or curve is as long as nothing: a line to its end is the same.
[[nodiscard]] bool is_point_like(const PathBlock& block, const Point& start);

}  // namespace stanok::motion
