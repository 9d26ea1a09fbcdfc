// Integer codes of an axis setpoint, for drives that take increments.
//
// Position and velocity are coded apart: the position in whole increments, as the measuring system
// counts them; the velocity kmv times finer, so that what is derived from it is worth deriving.
// Source: V. Kombarov, V. Sorokin, stability of contour feed (2013), eqs. (11) to (14), with
// rounding to the nearest integer; docs/developer/motion.md#codes.
#pragma once

#include <cstdint>

#include "base/numeric.h"
#include "base/rt_safe.h"

namespace stanok::motion {

struct CodeScale {
  double resolution = 0.001;  // mm or deg per increment
  double kmv = 10000.0;       // units of the velocity code per increment and cycle
};

[[nodiscard]] constexpr std::int64_t position_code(double position, const CodeScale& scale)
    RT_SAFE {
  return nearest_integer(position / scale.resolution);
}

// Mean velocity of the cycle that led from `before` to `position`.
[[nodiscard]] constexpr std::int64_t velocity_code(double before, double position,
                                                   const CodeScale& scale) RT_SAFE {
  return nearest_integer((position - before) / scale.resolution * scale.kmv);
}

}  // namespace stanok::motion
