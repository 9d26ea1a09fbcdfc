#include "motion/profile/speed_piece.h"

#include <algorithm>

#include "motion/path/geometry.h"

namespace stanok::motion {

SpeedPiece speed_piece(const Piece& piece, double part) RT_SAFE {
  constexpr double speed_max = 1e6;
  constexpr double acceleration_max = 1e9;
  constexpr double jerk_max = 1e12;
  const PieceLimits limits = piece_limits(piece.bounds, part * piece.feed_per_s);
  return {.length = piece.length,
          .v = std::min(limits.v, speed_max),
          .ramp = {.a = std::min(limits.a, acceleration_max), .j = std::min(limits.j, jerk_max)}};
}

}  // namespace stanok::motion
