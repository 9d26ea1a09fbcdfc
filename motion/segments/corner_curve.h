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
  bool keeps_speed = false;       // of the blocks, nearly: the time need not be asked for
  double time_lost = 0.0;         // s, against both blocks at their top speed
  // How often the time lost counts against that of a stop: a swing takes more of both blocks, and a
  // plan has less to change its speed on.
  double caution = 1.0;
};

// The largest blend within the tolerance and the soft limits, or a swing where that is faster; none
// where there is no such curve. Which of them it is does not depend on the feed, so that a higher
// feed is never slower for the other curve.
[[nodiscard]] std::optional<CornerCurve> corner_curve(const CornerPlace& place,
                                                      const Tolerance& tolerance,
                                                      const MotionConfig& config);

}  // namespace stanok::motion
