// SensorCount: by which steps the power of a sensor goes, as far as they were seen: the smallest
// is its count, of whole watts or of the register of a drive; the usual one is its noise.
//
// Part of the power watch of a channel, in the cycle; allocates nothing. Invariant: the usual step
// is no smaller than the count.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/rt_safe.h"

namespace stanok::process {

class SensorCount {
 public:
  // A dead sensor may flicker by three of its counts to either side.
  static constexpr double flicker_counts = 6.5;

  // The next value, once a cycle. The usual step, a median that follows slowly, is that of the
  // noise: a cut that changes makes few great ones.
  void learn(double power_w) RT_SAFE {
    const double step = has_seen_ ? std::abs(power_w - seen_w_) : 0.0;
    if (step > 0.0) {
      count_w_ = count_w_ > 0.0 ? std::min(count_w_, step) : step;
      step_w_ =
          std::max(count_w_, step > step_w_ ? step_learning * step_w_ : step_w_ / step_learning);
    }
    seen_w_ = power_w;
    has_seen_ = true;
  }

  [[nodiscard]] double count_w() const RT_SAFE { return count_w_; }
  [[nodiscard]] double usual_step_w() const RT_SAFE { return step_w_; }
  [[nodiscard]] bool is_within_flicker(double power_w, double of_w) const RT_SAFE {
    return std::abs(power_w - of_w) <= flicker_counts * count_w_;
  }

 private:
  static constexpr double step_learning = 1.05;

  double seen_w_ = 0.0;
  double count_w_ = 0.0;  // the smallest step
  double step_w_ = 0.0;   // the usual one
  bool has_seen_ = false;
};

}  // namespace stanok::process
