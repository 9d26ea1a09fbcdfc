// RestPlan: a way to rest along the path, as phases, and how far it has been run.
//
// The override planner drafts one, phase by phase, and the cycle runs it. Real-time; the room for
// phases is fixed.
#pragma once

#include <array>
#include <cstddef>

#include "base/rt_safe.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class RestPlan {
 public:
  static constexpr std::size_t capacity = 48;

  void clear() RT_SAFE;
  [[nodiscard]] bool has_room() const RT_SAFE;
  void add(const PhaseRun& run) RT_SAFE;
  // The first `time` of a change of speed from `from` to v, and v held if that is done before.
  // Returns the state then.
  PathMotion add_part(const PhaseRun& run, const PathMotion& from, double v, double time) RT_SAFE;
  // Constant speed from s0 to s1.
  void add_hold(double s0, double s1, double v) RT_SAFE;
  // The last phase ends at s, which it misses by rounding.
  void end_at(double s) RT_SAFE;
  // Runs for `time`; returns what is left of it once the plan is at rest.
  [[nodiscard]] double run(double time, PathMotion& motion) RT_SAFE;
  // The path coordinate counts from ds later on.
  void shift(double ds) RT_SAFE;

 private:
  std::array<Phase, capacity> phases_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
  double t_ = 0.0;  // within the current phase
};

}  // namespace stanok::motion
