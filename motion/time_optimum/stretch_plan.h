// StretchPlan: the fastest phases over a stretch of a plan between two of its states.
//
// The stretch is laid out in intervals, planned (motion/time_optimum/speed_optimum.h), made into
// phases and proved; intervals that use too much get smaller shares of their limits, and all is
// planned anew. Owner: the improvement of plans.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "motion/profile/profile.h"
#include "motion/time_optimum/limit_grid.h"
#include "motion/time_optimum/optimum_phases.h"
#include "motion/time_optimum/path_index.h"
#include "motion/time_optimum/phase_list.h"
#include "motion/time_optimum/speed_optimum.h"

namespace stanok::motion {

// Of a path with a plan: from `s0` to `s1`, by the phases given, which begin and end there or
// beyond.
struct Stretch {
  std::span<const Segment> segments;   // of the whole path
  std::span<const double> jerk_parts;  // that they may use
  const PathIndex* index = nullptr;
  std::span<const Phase> phases;
  double s0 = 0.0;
  double s1 = 0.0;
};

class StretchPlan {
 public:
  // Of acceleration and jerk: what is left lets the pace begin to change
  // (motion/interpolation/pace.h).
  static constexpr double force_max = 0.997;

  explicit StretchPlan(const MotionConfig& config)
      : axis_count_(config.axis_count), grid_(config) {}

  // Phases from s0 to s1 that join the plan at both ends and are faster than it; empty: none were
  // found. They stay until the next call.
  [[nodiscard]] std::span<const Phase> plan(const Stretch& stretch);

 private:
  // An end of the stretch: the state from which the spline goes on, and, where the path is at rest
  // there, the phase of constant jerk next to rest.
  struct End {
    EndState state;
    double s = 0.0;
    std::optional<Phase> rest;
  };

  [[nodiscard]] static End begin_of(const Stretch& stretch);
  [[nodiscard]] static End end_of(const Stretch& stretch);
  void estimate(const Stretch& stretch, const End& begin, const End& end);
  [[nodiscard]] bool lay_grid(const Stretch& stretch, const End& begin, const End& end);
  [[nodiscard]] bool is_laid_whole(const Segment& segment) const;
  [[nodiscard]] bool tells_of_peaks(const Stretch& stretch, std::size_t segment,
                                    std::size_t first_interval) const;
  void lay_knots(const Stretch& stretch, PhaseWalk& walk, std::size_t segment, const End& begin,
                 const End& end, std::size_t first, double longest);
  [[nodiscard]] bool search(const Stretch& stretch, const End& begin, const End& end);
  void start_from_plan(const Stretch& stretch, double s0);
  void slow_down(double less);
  void make_phases(const End& begin, const End& end);
  [[nodiscard]] bool tighten(std::span<const Phase> phases, int proof);

  int axis_count_;
  LimitGrid grid_;
  SpeedOptimum optimum_;
  SpeedSpline spline_;
  std::vector<double> estimates_;  // of v^2 at the ends of segments
  std::vector<double> knots_;
  std::vector<LimitShare> shares_;
  PhaseUse use_;
  std::vector<Phase> planned_;
};

}  // namespace stanok::motion
