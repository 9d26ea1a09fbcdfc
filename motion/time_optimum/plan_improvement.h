// PlanImprovement: a speed plan made faster where axes limit it.
//
// A plan of ramps keeps limits that are constant along each segment. Stretches on which it comes
// below the programmed feed are planned again against the limits of every axis at each place
// (motion/time_optimum/stretch_plan.h), between states of the plan that stay. Where two stretches
// meet, the second one begins within the first. A stretch whose proof fails is divided; one that is
// not faster stays as it is. Owner: the channel's preparation.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/profile/profile.h"
#include "motion/time_optimum/path_index.h"
#include "motion/time_optimum/stretch_plan.h"

namespace stanok::motion {

// Segments, and the part of its jerk that each may use: less at a corner where two legs overlap.
struct PlannedPath {
  std::span<const Segment> segments;
  std::span<const double> jerk_parts;
  bool follows_others = false;  // the motion comes from segments that were planned before
  bool goes_on = false;         // and goes on along segments that will be planned later
};

class PlanImprovement {
 public:
  explicit PlanImprovement(const MotionConfig& config);

  // `phases` run along the segments from their start to their end; `s` counts from there.
  void improve(const PlannedPath& path, std::vector<Phase>& phases);

 private:
  // From `s0` to `s1`, by the phases from `first` to before `last`.
  struct Part {
    double s0 = 0.0;
    double s1 = 0.0;
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void find_parts(const std::vector<Phase>& phases);
  void add_part(const std::vector<Phase>& phases, std::size_t first, std::size_t last);
  [[nodiscard]] bool holds_feed(const Phase& phase) const;
  [[nodiscard]] bool stays(std::size_t segment) const;
  [[nodiscard]] bool may_gain(const Part& part) const;
  [[nodiscard]] Stretch stretch_of(const std::vector<Phase>& phases, const Part& part) const;
  [[nodiscard]] bool plan_joined(const std::vector<Phase>& phases, const Part& part);
  [[nodiscard]] bool plan_from(std::size_t first, const std::vector<Phase>& phases,
                               const Part& part);
  [[nodiscard]] Part with_room(const std::vector<Phase>& phases, const Part& part) const;
  [[nodiscard]] bool plan_part(const std::vector<Phase>& phases, const Part& part);
  [[nodiscard]] bool plan_alone(const std::vector<Phase>& phases, const Part& part);
  void divide(const std::vector<Phase>& phases, const Part& part);

  [[nodiscard]] std::size_t phases_on(std::size_t segment) const;
  void join_pace_limits();

  StretchPlan stretch_plan_;
  PaceLimits widest_;  // of any stretch
  PlannedPath path_;
  PathIndex index_;
  std::vector<Part> parts_;      // the last one first
  std::vector<Phase> improved_;  // up to the place that is done
  double done_ = 0.0;
  std::size_t last_planned_ = 0;  // of them, the first phase of the stretch planned last
  std::vector<Phase> joined_;
};

}  // namespace stanok::motion
