// How far a curve that takes the place of a corner is from the blocks that meet there.
#pragma once

#include <cmath>
#include <span>

#include "motion/path/path.h"
#include "motion/path/shape.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// What curves through corners use of a tolerance. The rest covers the chord between two setpoints,
// which passes an inside corner a little farther off than the curve does, and what lies between the
// samples of deviation_share.
[[nodiscard]] inline Tolerance used_by_curves(const Tolerance& tolerance) {
  constexpr double part = 0.97;
  return {part * tolerance.mm, part * tolerance.deg};
}

// The deviation of a curve relative to the tolerance, by its reach L into both blocks: linear with
// the kink at the corner, quadratic with the step of curvature.
struct Growth {
  double kink = 0.0;
  double step = 0.0;

  [[nodiscard]] double share(double reach) const { return (kink + step * reach) * reach; }
  // The reach at which the share is 1.
  [[nodiscard]] double reach() const { return 2.0 / (kink + std::sqrt(kink * kink + 4.0 * step)); }
  // d log(share) / d log(reach), between 1 and 2.
  [[nodiscard]] double exponent(double reach) const {
    const double linear = kink;
    const double quadratic = step * reach;
    return linear + quadratic > 0.0 ? (linear + 2.0 * quadratic) / (linear + quadratic) : 1.0;
  }
};

// A form of curves that deviate by kink * L |t_out - t_in| + step * L^2 |k_out - k_in|, for
// tangents t and curvatures k at the corner.
struct Bulge {
  double kink = 0.0;
  double step = 0.0;
};

[[nodiscard]] Growth growth(const Segment& incoming, const Segment& outgoing, const Bulge& bulge,
                            const Tolerance& tolerance, const MotionConfig& config);

// The distance r from the corner of two straight segments at which the point corner - r t_in + r
// t_out still keeps `tolerance`, against the corner and against either leg
// (docs/developer/motion.md#overlap).
[[nodiscard]] double corner_reach(const Segment& incoming, const Segment& outgoing,
                                  const Tolerance& tolerance, const MotionConfig& config);

// Largest deviation of the curve from the programmed path over `incoming` and `outgoing`, as a
// share of the tolerance, found at samples; includes the distance at which the corner itself is
// passed.
[[nodiscard]] double deviation_share(std::span<const Shape> curve, double reach,
                                     const Segment& incoming, const Segment& outgoing,
                                     const Tolerance& tolerance, const MotionConfig& config);

// What a curve may take of a segment: all of a line, part of an arc or of a programmed curve.
[[nodiscard]] double replaceable(const Segment& segment);

}  // namespace stanok::motion
