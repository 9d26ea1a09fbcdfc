// Blends: quintic curves that replace the corner between two segments, within tolerance.
//
// A blend leaves the incoming segment at the path length L (its reach) before the corner and enters
// the outgoing segment L after it, with their tangents and curvatures, in all axes together. Its
// shape has control points at L, beta L and gamma L from the corner; between two lines its largest
// deviation is exactly L (1 + 5 beta + 10 gamma) / 32 * |t_out - t_in|, reached at the corner.
// Derivation and choice of beta and gamma: docs/developer/motion.md#blends.
#pragma once

#include <optional>

#include "motion/path/path.h"
#include "motion/path/shape.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// The fastest shape for a profile that passes the sharpest point at constant speed under a limit of
// jerk: least q''' for a given deviation and reach (docs/developer/motion.md#blends).
inline constexpr double blend_beta = 0.6;
inline constexpr double blend_gamma = 0.15;

struct Blend {
  Shape shape;
  double reach = 0.0;  // L
};

// The longest blend between two segments that meet, up to `reach_max`, within `tolerance`; none
// when even the shortest sensible one deviates too far.
[[nodiscard]] std::optional<Blend> fit_blend(const Segment& incoming, const Segment& outgoing,
                                             double reach_max, const Tolerance& tolerance,
                                             const MotionConfig& config);

}  // namespace stanok::motion
