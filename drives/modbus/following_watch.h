// FollowingWatch: whether an axis has been away from its targets for too long.
//
// Shorter excursions of the following error come from a late target, not from the axis. Owned by
// the exchange of one axis, on the bus thread. Time is given by the caller.
#pragma once

#include <chrono>
#include <cmath>
#include <optional>

#include "base/rt_safe.h"

namespace stanok::drives {

class FollowingWatch {
 public:
  explicit FollowingWatch(double error_max) : error_max_(error_max) {}

  // True: the error has been too large for longer than a late target explains.
  [[nodiscard]] bool is_exceeded(double error, std::chrono::nanoseconds now) RT_SAFE {
    if (std::fabs(error) <= error_max_) {
      since_.reset();
    } else if (!since_) {
      since_ = now;
    }
    return since_ && now - *since_ > excursion_max;
  }

 private:
  static constexpr std::chrono::milliseconds excursion_max{100};

  double error_max_;
  std::optional<std::chrono::nanoseconds> since_;
};

}  // namespace stanok::drives
