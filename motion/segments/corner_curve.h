// The curve that takes the place of a corner: a blend, or a swing where that is faster.
#pragma once

#include <optional>
#include <vector>

#include "motion/path/path.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// Two blocks that meet in a corner.
struct CornerPlace {
  const Segment& incoming;
  const Segment& outgoing;
  double left = 0.0;  // of the incoming block, what a curve may take
};

struct CornerCurve {
  std::vector<Segment> segments;  // in path order, with their bounds
  double reach = 0.0;             // into both blocks
  double v = 0.0;                 // at which it is passed, where it is even; mm/s
  bool keeps_speed = false;       // nearly: the time need not be asked for
  double time_lost = 0.0;         // s, against both blocks at their top speed
};

// The largest blend within the tolerance and the soft limits; none where there is no such curve.
[[nodiscard]] std::optional<CornerCurve> blend_at(const CornerPlace& place,
                                                  const Tolerance& tolerance,
                                                  const MotionConfig& config);

// `blend`, or a swing that is passed faster where the blocks have no kink, only a step of
// curvature.
[[nodiscard]] CornerCurve faster_of_tangent(const CornerPlace& place, const Tolerance& tolerance,
                                            const MotionConfig& config, CornerCurve blend);

// The fastest curve that loses less than `lost_max`; `blend` is the blend of the corner.
[[nodiscard]] std::optional<CornerCurve> faster_curve(const CornerPlace& place,
                                                      const Tolerance& tolerance,
                                                      const MotionConfig& config,
                                                      std::optional<CornerCurve> blend,
                                                      double lost_max);

}  // namespace stanok::motion
