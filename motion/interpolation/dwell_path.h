// DwellPath: an equivalent dwell path, for the length of which the axes rest at the feed of the
// path: a feed law or an interruption puts it in.
//
// Thread: the cycle. Owner: the interpolator. Invariant: while it is on, the axes stand.
#pragma once

#include "base/rt_safe.h"
#include "motion/interpolation/feed_interruption.h"
#include "motion/profile/feed_control.h"

namespace stanok::motion {

class DwellPath {
 public:
  // 0: none.
  void begin(double length_mm, const StandFeed& feed) RT_SAFE {
    left_mm_ = length_mm;
    feed_ = feed;
  }
  void drop() RT_SAFE { left_mm_ = 0.0; }
  [[nodiscard]] bool is_on() const RT_SAFE { return left_mm_ > 0.0; }

  // Goes on along it; returns what is left of the time at its end.
  [[nodiscard]] double advance(const FeedControl& control, double time) RT_SAFE;

  // The programmed feed there, mm/s; 0 where there is none.
  [[nodiscard]] double feed_commanded(const FeedControl& control) const RT_SAFE {
    return is_on() ? feed_.per_s * control.spindle_part(feed_.rev_per_min) : 0.0;
  }

 private:
  double left_mm_ = 0.0;
  StandFeed feed_;
};

}  // namespace stanok::motion
