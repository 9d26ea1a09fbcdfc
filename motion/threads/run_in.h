// RunIn: watches a spindle for the instant at which the path must leave its rest so that it is in
// the law of the thread at the start angle.
//
// The run-in begins half its turns before the start angle comes, with the limits of the chain's
// entry, or where a run-in by them could not be braked off before the first corner with those of
// the whole chain. A spindle that has not come to its speed is waited for, one that stays too fast
// for the axes is refused (docs/developer/motion.md#threads). Thread: the cycle. Owner:
// SynchronousRun, while its path is at rest at the start. Invariant: only an angle that was watched
// from cycle to cycle, with one set of limits, begins a run-in.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/profile.h"
#include "motion/threads/spindle_observer.h"
#include "motion/threads/thread_law.h"

namespace stanok::motion {

class RunIn {
 public:
  enum class Answer : std::uint8_t { waits, begins, too_fast };

  explicit RunIn(double cycle_s) : cycle_s_(cycle_s) {}

  void begin(const SpindleCoupling& coupling) RT_SAFE;

  // Once a cycle, while the path may begin or not: the speed of the spindle, and with it the limits
  // of the run-in.
  void watch(const SpindleMotion& spindle) RT_SAFE;
  // Once a cycle behind it, if the path may begin.
  [[nodiscard]] Answer advance(const SpindleMotion& spindle) RT_SAFE;
  // The path may not begin: the start angle may pass meanwhile.
  void forget_angle() RT_SAFE { has_watched_ = false; }

  // Of the run-in; known after `watch`.
  [[nodiscard]] const RampLimits& limits() const RT_SAFE { return limits_; }
  // Valid when the answer was that it begins.
  [[nodiscard]] const RunInStart& start() const RT_SAFE { return start_; }

 private:
  [[nodiscard]] bool is_clear_of_corner(double speed) const RT_SAFE;
  void choose_limits(double speed) RT_SAFE;
  [[nodiscard]] bool keeps_speed(const SpindleMotion& spindle) const RT_SAFE;
  [[nodiscard]] Answer judge_speed(const SpindleMotion& spindle) const RT_SAFE;
  [[nodiscard]] bool is_due(const SpindleMotion& spindle) RT_SAFE;

  double cycle_s_;
  SpindleCoupling coupling_;
  RampLimits limits_;
  bool is_by_chain_ = false;  // with its limits, not those of the entry
  double mean_speed_ = 0.0;   // over about the duration of the run-in, in turns/s
  double whole_turns_before_ = 0.0;
  bool has_watched_ = false;
  RunInStart start_;
};

}  // namespace stanok::motion
