// Arc length of a segment against its parameter u, and the way back: u from s.
//
// ds/du = |dP/du| over the axes of the metric. It is integrated by Gauss-Legendre with eight nodes:
// for quintics on intervals of at most 1/16 in u, for arcs whose radius changes from the start.
// u(s) starts from a cubic Hermite interpolation of the stored knots and is mended by third-order
// Newton steps until the arc length agrees to rounding. docs/developer/motion.md#path.
#pragma once

#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::motion {

// Arc length of the whole segment; for a quintic from its knots.
[[nodiscard]] double arc_length(const Geometry& geometry) RT_SAFE;

// Fills the knots of a quintic from its coefficients.
void measure(Geometry& quintic) RT_SAFE;

// The parameter at arc length s in [0, length].
[[nodiscard]] double parameter_at(const Geometry& geometry, double s, double length) RT_SAFE;

}  // namespace stanok::motion
