// TapReversal: what a tap asks of its spindle on the way in, at the bottom and on the way out.
//
// The spindle is stopped for the bottom, dwells there with the path, turns back and brings the path
// to where it began. One that was left in its hole turns back at once, and is stopped outside
// (docs/developer/motion.md#threads). Thread: the cycle. Owner: SynchronousRun, while its path
// follows the spindle of a tap. Invariant: an order is given once, in the cycle in which it is due.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/profile.h"
#include "motion/threads/spindle_observer.h"

namespace stanok::motion {

// What a tap asks of the spindle, from this cycle on.
struct SpindleOrder {
  enum class Kind : std::uint8_t {
    none,
    stop_within,  // comes to rest after `turns`
    turn_back,    // against its direction, `factor` times as fast, no sooner than `acceleration`
    go_on,        // as it did before
    turn_out,     // at `speed`, no sooner than `acceleration`
    stop,
  };
  Kind kind = Kind::none;
  std::int32_t spindle = 0;
  double turns = 0.0;
  double factor = 1.0;
  double speed = 0.0;         // turns/s, clockwise > 0
  double acceleration = 0.0;  // turns/s^2
};

// The tap is out.
[[nodiscard]] inline bool ends_tap(const SpindleOrder& order) RT_SAFE {
  return order.kind == SpindleOrder::Kind::go_on || order.kind == SpindleOrder::Kind::stop;
}

class TapReversal {
 public:
  explicit TapReversal(double cycle_s) : cycle_s_(cycle_s) {}

  // The path leaves its rest; of a thread nothing is asked.
  void begin(const SpindleCoupling& coupling) RT_SAFE;

  [[nodiscard]] bool is_tap() const RT_SAFE {
    return coupling_.kind == SpindleCoupling::Kind::tap || is_taken_out();
  }
  // It stood in its hole when the chain began.
  [[nodiscard]] bool is_taken_out() const RT_SAFE {
    return coupling_.kind == SpindleCoupling::Kind::tap_out;
  }
  // The spindle turns back.
  [[nodiscard]] bool returns() const RT_SAFE { return stage_ == Stage::returns; }

  // Once a cycle: what is asked of the spindle now. `place`: s by the law of the thread.
  [[nodiscard]] SpindleOrder advance(const SpindleMotion& spindle, double place,
                                     const PathMotion& path) RT_SAFE;
  // A stop with all that the spindle has, wherever it is.
  [[nodiscard]] SpindleOrder stop_at_once(const SpindleMotion& spindle) const RT_SAFE;
  // The tap is out.
  [[nodiscard]] SpindleOrder go_on() const RT_SAFE;
  // Both, as far as the observer sees.
  [[nodiscard]] static bool stand(const SpindleMotion& spindle, const PathMotion& path) RT_SAFE;

 private:
  enum class Stage : std::uint8_t { goes_in, stops, dwells, returns };

  [[nodiscard]] SpindleOrder stop_within(double turns) const RT_SAFE;

  double cycle_s_;
  SpindleCoupling coupling_;
  Stage stage_ = Stage::goes_in;
  std::int64_t dwell_cycles_ = 0;
};

}  // namespace stanok::motion
