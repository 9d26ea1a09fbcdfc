// PlanRun: runs the committed plan, as it was made or at a pace (motion/interpolation/pace.h).
//
// At the pace 1 it is run in the chain's own clock, exactly. Other paces change the time of plans
// that leave room for it (PaceLimits); they are taken and left where the motion is the same to the
// bit of its state. Thread: the cycle. Owner: the interpolator. Invariant: the motion it gives is
// that of the cursor's current phase at its time and pace.
#pragma once

#include <cstdint>
#include <optional>

#include "base/rt_safe.h"
#include "motion/interpolation/nominal_run.h"
#include "motion/interpolation/pace.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/interpolation/stop_brake.h"
#include "motion/path/path_queue.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class PlanRun {
 public:
  explicit PlanRun(const MotionConfig& config)
      : cycle_s_(config.cycle_s),
        nominal_(config.cycle_s),
        brake_(config),
        stop_limits_(stop_limits_of(config)) {}

  // The current phase began `time` ago, at the pace 1.
  void begin(double time = 0.0) RT_SAFE;

  // The plan is run as it was made.
  [[nodiscard]] bool is_nominal() const RT_SAFE { return pace_.is_nominal(); }
  // Where the cursor is, the plan may be run at a pace.
  [[nodiscard]] static bool is_paced(const PathQueue& queue, const PathCursor& cursor) RT_SAFE {
    return cursor.has_phase() && cursor.phase(queue).pace.holds();
  }

  // Goes over to the plan where it stands in the very state of `motion`. False: it does not, yet.
  [[nodiscard]] bool rejoin(PathQueue& queue, PathCursor& cursor, const PathMotion& motion) RT_SAFE;
  // The same at any pace; at once at `asked` from rest to rest.
  [[nodiscard]] bool rejoin_at_pace(PathQueue& queue, PathCursor& cursor, const PathMotion& motion,
                                    double asked) RT_SAFE;
  // At the start of a phase with a = 0, to which the motion has come at an even speed.
  [[nodiscard]] bool rejoin_at_start(PathQueue& queue, PathCursor& cursor, const PathMotion& motion)
      RT_SAFE;
  // At rest at the start of a chain any pace may be taken.
  void start_at(const PathQueue& queue, const PathCursor& cursor, const PathMotion& motion,
                double asked) RT_SAFE;

  // Runs for `time`, towards the pace `target`; returns what is left of it at the end of the chunk,
  // or where a plan that is run at a pace ends.
  [[nodiscard]] double advance(PathQueue& queue, PathCursor& cursor, double target, UsedLimits used,
                               double time, PathMotion& motion) RT_SAFE;
  // At the pace that there is: all that can be done where the override planner has nothing to
  // offer.
  [[nodiscard]] double go_on(PathQueue& queue, PathCursor& cursor, double time, PathMotion& motion)
      RT_SAFE {
    return advance(queue, cursor, pace_.rate, UsedLimits::of_axes, time, motion);
  }

  // A stop: runs for `time` towards rest, as fast as the stop limits of the axes allow, over ramps,
  // too. None, with nothing done: there is no way from here that is known to keep them. It goes on
  // until the motion rests, or is released.
  [[nodiscard]] bool stops() const RT_SAFE { return brake_.is_on(); }
  [[nodiscard]] std::optional<double> stop(PathQueue& queue, PathCursor& cursor, double time,
                                           PathMotion& motion) RT_SAFE;
  // Takes the change of the pace away that a stop has made, which is over then.
  [[nodiscard]] double release(PathQueue& queue, PathCursor& cursor, double time,
                               PathMotion& motion) RT_SAFE;

  // Time that the phases of the current chunk still take at the pace 1, or more than `farthest`.
  [[nodiscard]] double time_to_end(const PathQueue& queue, const PathCursor& cursor,
                                   double farthest) const RT_SAFE {
    return nominal_.time_to_end(queue, cursor, farthest);
  }

 private:
  [[nodiscard]] PaceStep next_step(const PathQueue& queue, const PathCursor& cursor, double target,
                                   double time, double s) RT_SAFE;
  [[nodiscard]] double advance_at_pace(PathQueue& queue, PathCursor& cursor, double target,
                                       double time, PathMotion& motion) RT_SAFE;
  [[nodiscard]] PaceStep rest_of_step(double time) const RT_SAFE;
  enum class Ends : std::uint8_t { where_ramps_begin, with_chunk };
  [[nodiscard]] double follow(PathQueue& queue, PathCursor& cursor, const PaceStep& step,
                              double time, Ends ends, PathMotion& motion) RT_SAFE;

  double cycle_s_;
  NominalRun nominal_;
  Pace pace_;
  StopBrake brake_;
  double second_ = 0.0;  // p'' of the step of a stop
  double stop_limits_;
  UsedLimits used_ = UsedLimits::of_axes;  // by a change of the pace
};

}  // namespace stanok::motion
