// FollowingWatch: whether an axis has been away from its targets for too long.
//
// Shorter excursions of the following error come from a late target, not from the axis. A cycle
// that came late goes on where it was, while the drive went on with its velocity: such a target
// falls back behind it, and the axis may be away by as much. What fell back is added up and
// forgotten with a time constant, so that it is never more than the way of that time; the error of
// an axis that is blocked grows with every target, and passes it. Owned by the exchange of one
// axis, on the bus thread. Time is given by the caller.
#pragma once

#include <chrono>
#include <optional>

#include "base/rt_safe.h"

namespace stanok::drives {

class FollowingWatch {
 public:
  // mm or deg, and per s².
  FollowingWatch(double error_max, double acceleration_max)
      : error_max_(error_max), acceleration_max_(acceleration_max) {}

  // A target of the cycle was taken by the drive: mm or deg, and per s.
  void note_target(double position, double velocity, std::chrono::nanoseconds now) RT_SAFE;
  // The axis follows no targets of the cycle.
  void forget_targets() RT_SAFE;

  // True: the error has been too large for longer than a late target explains.
  [[nodiscard]] bool is_exceeded(double error, std::chrono::nanoseconds now) RT_SAFE;

 private:
  struct Target {
    double position;
    double velocity;
    std::chrono::nanoseconds time;
  };
  // By how much a target lies behind where the axis would be after the last one, braking not
  // counted; at most the way to there, which is that of a target that stands.
  [[nodiscard]] double fall_behind(const Target& last, const Target& target) const RT_SAFE;

  double error_max_;
  double acceleration_max_;
  double fallen_back_ = 0.0;  // mm or deg
  std::optional<Target> last_;
  std::optional<std::chrono::nanoseconds> since_;
};

}  // namespace stanok::drives
