#include "channels/axes/straight_jog.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stanok::channels {
namespace {

// How far an axis may go in the direction that it is to take; negative: it is beyond its end.
double room(const motion::AxisLimits& limits, double at, double step) RT_SAFE {
  return step > 0.0 ? limits.position_max - at : at - limits.position_min;
}

// What the axes allow along the way.
struct WayLimits {
  double length = std::numeric_limits<double>::infinity();
  motion::AxisMoveLimits move{.speed = std::numeric_limits<double>::infinity(),
                              .ramp = {.a = std::numeric_limits<double>::infinity(),
                                       .j = std::numeric_limits<double>::infinity()}};

  void keep(const motion::AxisLimits& limits, double room, double share) RT_SAFE {
    length = std::min(length, room / share);
    move.speed = std::min(move.speed, limits.velocity_max / share);
    move.ramp.a = std::min(move.ramp.a, limits.acceleration_max / share);
    move.ramp.j = std::min(move.ramp.j, limits.jerk_max / share);
  }
};

}  // namespace

std::string_view StraightJog::begin(const JogLine& line, std::span<const ManualAxis> axes,
                                    std::span<const AxisFeedback> drives,
                                    std::span<const kinematics::Jet> positions) RT_SAFE {
  const double sign = line.velocity > 0.0 ? 1.0 : -1.0;
  WayLimits way;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const double step = sign * line.direction[k];
    if (step == 0.0) continue;
    const AxisFeedback& drive = drives[k];
    if (!drive.referenced) return "E6059";
    if (step > 0.0 ? drive.limit_positive : drive.limit_negative) return "E6057";
    const double left = room(axes[k].limits, positions[k].value, step);
    if (left <= 0.0) return "E6053";
    way.keep(axes[k].limits, left, std::abs(step));
  }
  if (line.increment > way.length) return "E6053";
  if (line.increment > 0.0) way.length = line.increment;
  constexpr double endless_mm = 1e6;  // axes without ends
  way.length = std::min(way.length, endless_mm);
  way.move.speed = std::min(way.move.speed, std::abs(line.velocity));
  for (std::size_t k = 0; k < axes.size(); ++k) {
    from_[k] = positions[k].value;
    direction_[k] = line.direction[k];
  }
  move_.begin(0.0, sign * way.length, way.move);
  cycles_left_ = -1;
  is_active_ = true;
  has_place_ = false;
  return {};
}

void StraightJog::go(const AxisArray<double>& to, std::span<const ManualAxis> axes,
                     std::span<const kinematics::Jet> positions, double speed) RT_SAFE {
  double squared = 0.0;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    from_[k] = positions[k].value;
    squared += (to[k] - from_[k]) * (to[k] - from_[k]);
  }
  const double length = std::sqrt(squared);
  WayLimits way;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    direction_[k] = length > 0.0 ? (to[k] - from_[k]) / length : 0.0;
    const double share = std::abs(direction_[k]);
    if (share == 0.0) continue;
    way.keep(axes[k].limits, length * share, share);
    if (speed == 0.0) way.move.speed = std::min(way.move.speed, search_speed(axes[k]) / share);
  }
  if (speed > 0.0) way.move.speed = std::min(way.move.speed, speed);
  to_ = to;
  move_.begin(0.0, length, way.move);
  cycles_left_ = -1;
  is_active_ = true;
  has_place_ = true;
}

bool StraightJog::renew(const JogLine& line, std::int64_t cycles) RT_SAFE {
  constexpr double apart_max = 1e-6;  // rounding of where the axes are
  if (!is_active_ || cycles_left_ <= 0 || line.increment > 0.0) return false;
  for (std::size_t k = 0; k < axes_max; ++k)
    if (std::abs(line.direction[k] - direction_[k]) > apart_max) return false;
  const bool up = line.velocity > 0.0;
  if (move_.goes_up() == up) {
    cycles_left_ = cycles;
    return true;
  }
  stop();
  return false;
}

void StraightJog::stop() RT_SAFE {
  has_place_ = false;
  move_.stop();
  cycles_left_ = -1;
}

void StraightJog::advance(double cycle_s, std::span<kinematics::Jet> positions) RT_SAFE {
  if (!is_active_) return;
  if (cycles_left_ == 1) move_.stop();
  if (cycles_left_ > 0) --cycles_left_;
  move_.advance(cycle_s);
  const kinematics::Jet way = move_.position();
  for (std::size_t k = 0; k < positions.size() && k < axes_max; ++k)
    if (direction_[k] != 0.0) positions[k] = from_[k] + direction_[k] * way;
  is_active_ = !move_.is_at_rest();
  if (is_active_ || !has_place_) return;
  for (std::size_t k = 0; k < positions.size() && k < axes_max; ++k)
    if (direction_[k] != 0.0) positions[k] = kinematics::Jet(to_[k]);
}

}  // namespace stanok::channels
