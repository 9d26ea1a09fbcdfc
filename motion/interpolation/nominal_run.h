// NominalRun: runs the committed phases of a path in the chain's own clock.
//
// The time within a phase is counted in whole cycles from its first instant, so that nothing
// accumulates over a long phase; the fraction of a cycle that a chain leaves over is carried into
// the next one. Thread: the cycle. Owner: the interpolator. Invariant: the motion it gives is that
// of the cursor's current phase at its time.
#pragma once

#include "base/rt_safe.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/path/path_queue.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class NominalRun {
 public:
  explicit NominalRun(double cycle_s) : cycle_s_(cycle_s) {}

  // The current phase began `time` ago.
  void begin(double time = 0.0) RT_SAFE;

  // Since the current phase began.
  [[nodiscard]] double time() const RT_SAFE { return time_first_ + cycles_ * cycle_s_; }

  // Goes over to the phases where they stand in the very state of `motion`: in a phase of constant
  // speed, or at its start at rest. False: they do not, yet.
  [[nodiscard]] bool rejoin(PathQueue& queue, PathCursor& cursor, const PathMotion& motion) RT_SAFE;

  // Runs for `time`; returns what is left of it at the end of the chunk.
  [[nodiscard]] double advance(PathQueue& queue, PathCursor& cursor, double time,
                               PathMotion& motion) RT_SAFE;

  // Time that the phases of the current chunk still take, or more than `farthest`.
  [[nodiscard]] double time_to_end(const PathQueue& queue, const PathCursor& cursor,
                                   double farthest) const RT_SAFE;

 private:
  double cycle_s_;
  double time_first_ = 0.0;  // of the phase, before the whole cycles
  double cycles_ = 0.0;
};

}  // namespace stanok::motion
