#include "motion/interpolation/dwell_path.h"

namespace stanok::motion {

double DwellPath::advance(const FeedControl& control, double time) RT_SAFE {
  const double speed = control.hold ? 0.0 : feed_.per_s * control.feed_part(feed_.rev_per_min);
  if (left_mm_ > speed * time) {
    left_mm_ -= speed * time;
    return 0.0;
  }
  const double left = time - left_mm_ / speed;
  left_mm_ = 0.0;
  return left;
}

}  // namespace stanok::motion
