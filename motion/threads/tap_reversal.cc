// When the spindle of a tap stops and turns back (motion/threads/tap_reversal.h).
#include "motion/threads/tap_reversal.h"

#include <algorithm>
#include <cmath>

#include "base/numeric.h"

namespace stanok::motion {
namespace {

constexpr double spindle_standstill =
    0.05;  // turns/s, within what the observer sees of a spindle at rest
// A spindle is told to stop somewhat early, with less than it has: so it stops where it is told to,
// though the speed of the moment is not quite known.
constexpr double stop_reserve = 1.05;

// A spindle that brakes with all it has.
double turns_to_stop(double speed, double acceleration) RT_SAFE {
  return 0.5 * speed * speed / acceleration;
}

}  // namespace

void TapReversal::begin(const SpindleCoupling& coupling) RT_SAFE {
  coupling_ = coupling;
  stage_ = is_taken_out() ? Stage::dwells : Stage::goes_in;
  dwell_cycles_ = 0;
}

SpindleOrder TapReversal::advance(const SpindleMotion& spindle, double place,
                                  const PathMotion& path) RT_SAFE {
  if (!is_tap()) return {};
  if (stage_ == Stage::goes_in) {
    // The spindle obeys in this cycle, at the end of which it is predicted.
    const double turned = std::abs(spindle.speed) * cycle_s_;
    const double left = coupling_.bottom - place + turned;
    const double needed = turns_to_stop(spindle.speed, coupling_.spindle_acceleration);
    const bool is_due = left - turned <= stop_reserve * needed;
    if (!is_due) return {};
    stage_ = Stage::stops;
    return stop_within(std::max(left, 0.0));
  }
  if (stage_ == Stage::stops) {
    if (!stand(spindle, path)) return {};
    stage_ = Stage::dwells;
    dwell_cycles_ = ceiling(coupling_.dwell_s / cycle_s_);
    return {};
  }
  if (stage_ != Stage::dwells || dwell_cycles_-- > 0) return {};
  stage_ = Stage::returns;
  if (is_taken_out()) {
    return {.kind = SpindleOrder::Kind::turn_out,
            .spindle = coupling_.spindle,
            .speed = coupling_.out_speed,
            .acceleration = coupling_.spindle_acceleration};
  }
  return {.kind = SpindleOrder::Kind::turn_back,
          .spindle = coupling_.spindle,
          .factor = coupling_.return_speed_factor,
          .acceleration = coupling_.spindle_acceleration};
}

SpindleOrder TapReversal::stop_at_once(const SpindleMotion& spindle) const RT_SAFE {
  return stop_within(turns_to_stop(spindle.speed, coupling_.spindle_acceleration));
}

SpindleOrder TapReversal::stop_within(double turns) const RT_SAFE {
  return {.kind = SpindleOrder::Kind::stop_within, .spindle = coupling_.spindle, .turns = turns};
}

SpindleOrder TapReversal::go_on() const RT_SAFE {
  const auto kind = is_taken_out() ? SpindleOrder::Kind::stop : SpindleOrder::Kind::go_on;
  return {.kind = kind, .spindle = coupling_.spindle};
}

bool TapReversal::stand(const SpindleMotion& spindle, const PathMotion& path) RT_SAFE {
  return spindle.speed_wanted == 0.0 && std::abs(spindle.speed) < spindle_standstill &&
         std::abs(path.v) < spindle_standstill;
}

}  // namespace stanok::motion
