// Following errors beside what late targets explain.
#include "drives/modbus/following_watch.h"

#include <algorithm>
#include <cmath>

namespace stanok::drives {
namespace {

constexpr std::chrono::milliseconds excursion_max{100};
constexpr double forgotten_in_s = 0.1;  // to a part of 1/e

double seconds_between(std::chrono::nanoseconds from, std::chrono::nanoseconds to) RT_SAFE {
  return static_cast<double>((to - from).count()) * 1e-9;
}

}  // namespace

void FollowingWatch::note_target(double position, double velocity, std::chrono::nanoseconds now)
    RT_SAFE {
  const Target target{position, velocity, now};
  if (last_) {
    const double kept =
        fallen_back_ * std::exp(-seconds_between(last_->time, now) / forgotten_in_s);
    fallen_back_ = std::max(0.0, kept + fall_behind(*last_, target));
  }
  last_ = target;
}

double FollowingWatch::fall_behind(const Target& last, const Target& target) const RT_SAFE {
  if (last.velocity == 0.0) return 0.0;
  const double dt_s = seconds_between(last.time, target.time);
  const double way = std::fabs(last.velocity) * dt_s;
  const double went = std::copysign(1.0, last.velocity) * (target.position - last.position);
  return std::min(way - went, way) - 0.5 * acceleration_max_ * dt_s * dt_s;
}

void FollowingWatch::forget_targets() RT_SAFE {
  last_.reset();
  fallen_back_ = 0.0;
}

bool FollowingWatch::is_exceeded(double error, std::chrono::nanoseconds now) RT_SAFE {
  if (std::fabs(error) <= error_max_ + fallen_back_) {
    since_.reset();
  } else if (!since_) {
    since_ = now;
  }
  return since_ && now - *since_ > excursion_max;
}

}  // namespace stanok::drives
