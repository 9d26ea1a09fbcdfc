// StopBrake: the pace of a plan to rest, as fast as the stop limits of every axis allow.
//
// At the pace p = d(tau)/dt (motion/interpolation/pace.h) an axis of which the plan asks v, a, j
// has
//   acceleration  a p^2 + v p'          jerk  j p^3 + 3 a p p' + v p''.
// Signs count: what the curve takes in one sense is free in the other. In each cycle the most
// negative p'' is taken from which there is a *release*, which takes the most positive p'' in each
// cycle until p' = 0: at a pace below 1 that no more changes the plan keeps its limits. Where there
// is none, the release that was found before is followed. So there is always a way on that keeps
// the limits (docs/developer/motion.md#stops). Real-time; the work of a cycle is bounded.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/rt_safe.h"
#include "motion/interpolation/pace.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/interpolation/plan_trace.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"

namespace stanok::motion {

class StopBrake {
 public:
  static constexpr std::size_t steps_max = 160;  // of a release
  static constexpr int tries_max = 7;            // of a cycle: releases that are looked for

  explicit StopBrake(const MotionConfig& config);

  [[nodiscard]] bool is_on() const RT_SAFE { return is_on_; }
  void end() RT_SAFE { is_on_ = false; }

  // Begins at a pace of the plan, in whose current phase it has come to `elapsed`. False: the pace
  // changes so that no release is found.
  [[nodiscard]] bool begin(const PathQueue& queue, const PathCursor& cursor, double elapsed,
                           const Pace& pace) RT_SAFE;

  // The step of a cycle to rest. `elapsed` as above.
  [[nodiscard]] PaceStep brake(const PathQueue& queue, const PathCursor& cursor, double elapsed,
                               const Pace& from) RT_SAFE;
  // The step of a cycle to a pace that does not change.
  [[nodiscard]] PaceStep release(const PathQueue& queue, const PathCursor& cursor, double elapsed,
                                 const Pace& from) RT_SAFE;

  // Of the last cycle, for tests and benchmarks: steps of releases, and evaluations of the path.
  [[nodiscard]] std::size_t steps() const RT_SAFE { return steps_; }
  [[nodiscard]] std::size_t evaluations() const RT_SAFE { return trace_.evaluations(); }

 private:
  struct Range {
    double low = 0.0;
    double high = 0.0;
    [[nodiscard]] bool holds(double value) const RT_SAFE { return low <= value && value <= high; }
    [[nodiscard]] bool is_empty() const RT_SAFE { return !(low <= high); }
    void keep(double value, double slope, double least, double most) RT_SAFE;
  };
  using Ends = std::array<PlanTrace::Axes, 2>;
  // What p'' may be in a step from a pace at a time of the plan.
  [[nodiscard]] Range seconds(double time, const Pace& from) const RT_SAFE;
  [[nodiscard]] Range seconds(double time, const Pace& from, const Ends& ends, double times) const
      RT_SAFE;
  void measure(const Pace& from) RT_SAFE;
  [[nodiscard]] Ends ends_of_step(double time, const Pace& from) const RT_SAFE;
  [[nodiscard]] static PaceStep step(const Pace& from, double second, double time) RT_SAFE;
  [[nodiscard]] bool stays_within(const Pace& from, double second) const RT_SAFE;
  [[nodiscard]] bool has_release(double time, const Pace& from) RT_SAFE;
  [[nodiscard]] bool has_release_behind(const Pace& from, double second) RT_SAFE;
  [[nodiscard]] std::optional<double> last_second(const Pace& from, const Range& range) const
      RT_SAFE;
  [[nodiscard]] double hardest(const Pace& from, const Range& range) RT_SAFE;
  [[nodiscard]] PaceStep take(const Pace& from) RT_SAFE;
  [[nodiscard]] double known_second(const Pace& from) const RT_SAFE;
  [[nodiscard]] double follow(const Pace& from) RT_SAFE;
  void look(const PathQueue& queue, const PathCursor& cursor, double elapsed) RT_SAFE;

  const double cycle_s_;
  int cycles_ = 1;  // of a step
  double step_s_ = 0.0;
  double ahead_min_s_ = 0.0;
  struct Parts {
    AxisArray<double> acceleration{};  // 1 / stop limit
    AxisArray<double> jerk{};
    double used_max = 0.0;  // of these by plans at the pace 1
  };
  Parts parts_;
  PlanTrace trace_;
  bool is_on_ = false;
  double time_ = 0.0;  // of the plan, since the stop began
  Ends ends_;          // of the step
  double second_ = 0.0;
  int cycle_ = 0;  // of the step
  // The release that was found last, and how much of it has been followed.
  struct Release {
    std::array<double, steps_max> seconds{};
    std::size_t size = 0;
  };
  std::array<Release, 2> releases_{};  // the one that is known, and a draft
  std::size_t known_ = 0;
  std::size_t followed_ = 0;
  std::size_t steps_ = 0;
};

}  // namespace stanok::motion
