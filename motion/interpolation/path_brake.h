// PathBrake: a way to rest from any state within the limits, proved against the machine axes.
//
// The override planner works with limits that are constant along each segment. A plan that uses the
// limits of every axis at each place leaves those; from there a brake is drafted as a change of
// speed to rest under a part of the tangential limits, and accepted when every axis keeps its own
// limits at places close to each other, with what may lie between them to second order
// (motion/path/sampling.h). docs/developer/motion.md#pace. Real-time; the work of an attempt is
// bounded.
#pragma once

#include <cstddef>
#include <optional>

#include "base/rt_safe.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class PathBrake {
 public:
  explicit PathBrake(const MotionConfig& config)
      : config_(config), stop_limits_(stop_limits_of(config)) {}

  // The next attempt is the hardest brake.
  void restart() RT_SAFE { attempt_ = 0; }

  // One attempt from `from`, softer ones after harder ones. None: it would break a limit, or leave
  // the path that is seen and open, up to `wall`: s along the current chunk.
  [[nodiscard]] std::optional<PhaseRun> find(const PathQueue& queue, const PathCursor& cursor,
                                             double wall, const PathMotion& from, UsedLimits used)
      RT_SAFE;

 private:
  // What velocity, acceleration and jerk use of their limits, by axis.
  struct Uses {
    double t = 0.0;
    AxisArray<double> velocity{};
    AxisArray<double> acceleration{};
    AxisArray<double> jerk{};
  };
  // Where on the path, as places are visited one after another.
  struct Place {
    std::size_t segment = 0;
    double start = 0.0;  // of the segment, along the current chunk
  };

  [[nodiscard]] PhaseRun draft(const PathMotion& from, double part) const RT_SAFE;
  [[nodiscard]] bool keeps_limits(const Phase& phase, Place& place, std::size_t& samples) const
      RT_SAFE;
  [[nodiscard]] bool sample(const PathMotion& motion, Place& place, Uses& uses) const RT_SAFE;
  [[nodiscard]] double largest(const Uses& before, const Uses& at, const Uses& behind) const
      RT_SAFE;

  const MotionConfig config_;
  const double stop_limits_;
  double times_ = 1.0;  // the limits, that this attempt may use
  std::size_t attempt_ = 0;
  const PathQueue* queue_ = nullptr;
  double start_ = 0.0;    // of the current segment
  std::size_t seen_ = 0;  // segments
};

}  // namespace stanok::motion
