// Stairs of the speed plan: ramps below limits that rise or fall slowly over many short segments.
//
// A stair leads from a key point outward, forwards or backwards along the path, to a higher speed
// at a boundary farther out: some length at the key point's speed, then one ramp. It is placed so
// that no segment on its way is passed too fast (docs/developer/motion.md#profile).
#include <algorithm>

#include "motion/look_ahead/speed_plan.h"

namespace stanok::motion {

bool SpeedPlan::add_stair(Key& left, const Key& right, std::size_t far_end, Direction direction,
                          std::vector<Key>& pending) {
  const bool forward = direction == Direction::forward;
  const Key& from = forward ? left : right;
  Key key = best_stair(from, far_end, forward ? right.boundary : left.boundary);
  const RampLimits limits =
      limits_over(std::min(from.boundary, key.boundary), std::max(from.boundary, key.boundary));
  const double wait = stair_wait(from, key.boundary, key.v, limits);
  if (forward) {
    left.begins_stair = true;
    left.stair = {.first = left.boundary,
                  .last = key.boundary,
                  .v0 = left.v,
                  .v1 = key.v,
                  .top = key.v,
                  .wait_first = wait,
                  .up = limits,
                  .down = limits};
  } else {
    key.begins_stair = true;
    key.stair = {.first = key.boundary,
                 .last = right.boundary,
                 .v0 = key.v,
                 .v1 = right.v,
                 .top = key.v,
                 .wait_last = wait,
                 .up = limits,
                 .down = limits};
  }
  pending.push_back(key);
  return true;
}

// Tries boundaries further and further out and takes the first one at which the stair comes close
// to the limit; a stair that is too short spends its time on jerk, one too long below the limits.
SpeedPlan::Key SpeedPlan::best_stair(const Key& from, std::size_t nearest, std::size_t stop) const {
  constexpr double close = 0.8;
  Key best{.boundary = nearest, .v = std::min(from.v, boundary_limit(nearest))};
  double best_part = 0.0;
  const bool forward = stop > from.boundary;
  const std::size_t room = forward ? stop - nearest : nearest - stop;
  for (std::size_t step = 0; step < room; step += std::max<std::size_t>(1, step / 2)) {
    const std::size_t end = forward ? nearest + step : nearest - step;
    const double rise = boundary_limit(end) - from.v;
    if (rise <= 0.0) break;
    const double v = stair_speed(from, end);
    const double part = (v - from.v) / rise;
    if (part > best_part) {
      best = {.boundary = end, .v = v};
      best_part = part;
    }
    if (part >= close) break;
  }
  return best;
}

// The highest speed of a stair that ends at boundary `end`, its ramp as far out as possible.
double SpeedPlan::stair_speed(const Key& from, std::size_t end) const {
  const std::size_t first = std::min(from.boundary, end);
  const std::size_t last = std::max(from.boundary, end);
  const RampLimits limits = limits_over(first, last);
  const double length = distance(first, last);
  double high = std::min(boundary_limit(end), reachable_speed(from.v, length, limits));
  if (high <= from.v || slowest_.value(first, last - 1) < from.v) return from.v;
  const auto fits = [&](double v) {
    const RampCourse ramp(from.v, v, limits);
    const double latest = from.v > 0.0 ? std::max(length - ramp.length(), 0.0) : 0.0;
    return stair_fits(from, end, ramp, latest);
  };
  if (fits(high)) return high;
  double low = from.v;
  constexpr int halvings = 10;
  for (int k = 0; k < halvings; ++k) {
    const double v = 0.5 * (low + high);
    (fits(v) ? low : high) = v;
  }
  return low;
}

// The shortest wait before the ramp of a stair that keeps the limits.
double SpeedPlan::stair_wait(const Key& from, std::size_t end, double v,
                             const RampLimits& limits) const {
  if (from.v <= 0.0 || v <= from.v) return 0.0;
  const RampCourse ramp(from.v, v, limits);
  if (stair_fits(from, end, ramp, 0.0)) return 0.0;
  double high = std::max(distance(from.boundary, end) - ramp.length(), 0.0);
  double low = 0.0;
  constexpr int halvings = 10;
  for (int k = 0; k < halvings; ++k) {
    const double wait = 0.5 * (low + high);
    (stair_fits(from, end, ramp, wait) ? high : low) = wait;
  }
  return high;
}

// Whether the stair from the key point outward to boundary `end`, `wait` of length at the key's
// speed and then the ramp, keeps the speed of every segment; none may be slower than the key point.
bool SpeedPlan::stair_fits(const Key& from, std::size_t end, const RampCourse& ramp,
                           double wait) const {
  const bool outward_is_forward = end > from.boundary;
  for (std::size_t far = end; far != from.boundary;) {
    const double far_side = distance(from.boundary, far);
    if (far_side <= wait) break;
    const std::size_t segment = outward_is_forward ? --far : far++;
    if (v_[segment] < ramp.high() && wait + ramp.distance_to(v_[segment]) < far_side) return false;
  }
  return wait + ramp.length() <= distance(from.boundary, end) * (1.0 + 1e-12);
}

}  // namespace stanok::motion
