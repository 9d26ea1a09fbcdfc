// OverridePlanner: feed hold, resume and override on the committed path, planned in the cycle.
//
// Every cycle it tries to go on for one more cycle as asked, and accepts that only if from there a
// way to rest exists that keeps the limits of every segment it touches. The way found is kept: when
// a later wish is refused it is simply followed. So there is always a way to rest, and limits are
// kept without looking farther than the braking distance (docs/developer/motion.md#override).
// Real-time.
#pragma once

#include <array>
#include <cstddef>

#include "base/rt_safe.h"
#include "motion/interpolation/path_brake.h"
#include "motion/interpolation/path_sight.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"
#include "motion/profile/rest_plan.h"

namespace stanok::motion {

class OverridePlanner {
 public:
  explicit OverridePlanner(const MotionConfig& config)
      : cycle_s_(config.cycle_s), stop_limits_(stop_limits_of(config)), brake_(config) {}

  // Takes over, or starts afresh, with no way to rest known.
  void forget() RT_SAFE;
  // Takes over from a plan that leaves the limits of segments: with a brake that is proved against
  // the axes (motion/interpolation/path_brake.h), or not yet. `wall` as there.
  [[nodiscard]] bool take_over_braking(const PathQueue& queue, const PathCursor& cursor,
                                       double wall, const PathMotion& motion, UsedLimits used)
      RT_SAFE;

  // Runs for `time` from `motion`, which it replaces. Returns false, with nothing done, when it has
  // no plan that keeps the limits; possible only right after forget(). `left`: what remains of
  // `time` at the end of the chain, or at the wall. With the limits of stops what is asked is rest.
  [[nodiscard]] bool advance(const PathQueue& queue, const PathCursor& cursor,
                             const FeedControl& control, UsedLimits used, const PathWall& wall,
                             double time, PathMotion& motion, double& left) RT_SAFE;

  // Up to which overrides are followed, until it is bounded anew.
  void bound_override(double highest) RT_SAFE { override_max_ = highest; }
  [[nodiscard]] double override_max() const RT_SAFE { return override_max_; }

  // The path coordinate counts from ds later on: the next chunk was entered.
  void shift(double ds) RT_SAFE { plans_[current_].shift(ds); }

 private:
  enum class Caps { asked, hard };
  // What a search for a braking motion to rest came to.
  struct RestSearch {
    bool is_safe = false;
    double binding_speed = 0.0;  // what the place in the way asks for; 0: a wall
  };
  // The place ahead that leaves the least room to slow down for it.
  struct Tight {
    bool found = false;
    std::size_t segment = 0;
    double slack = 0.0;
    double v = 0.0;
    RampLimits limits{};
  };
  // What lies within the braking distance.
  struct BrakingRange {
    bool fits = false;     // a brake to rest under `limits` stays on known path
    std::size_t last = 0;  // segment in which it comes to rest
    RampLimits limits{};
    Tight tight{};
    double binding_speed = 0.0;
  };

  void extend_reach(const FeedControl& control) RT_SAFE;
  void narrow_reach(const FeedControl& control) RT_SAFE;
  [[nodiscard]] double cap(std::size_t segment, Caps caps) RT_SAFE;
  [[nodiscard]] bool find_plan(const FeedControl& control, double time, const PathMotion& motion)
      RT_SAFE;
  [[nodiscard]] RestSearch try_speed(const PathMotion& from, double v, double time, Caps caps)
      RT_SAFE;
  [[nodiscard]] bool try_creep(const PathMotion& from, double v, double time) RT_SAFE;
  [[nodiscard]] bool try_hop(const PathMotion& from) RT_SAFE;
  [[nodiscard]] RestSearch find_rest(PathMotion from, std::size_t segment, Caps caps) RT_SAFE;
  [[nodiscard]] BrakingRange survey(const PathMotion& from, std::size_t segment, Caps caps) RT_SAFE;
  [[nodiscard]] bool keeps(const PhaseRun& run, std::size_t first, std::size_t last, Caps caps)
      RT_SAFE;
  [[nodiscard]] bool ease(PathMotion& from, std::size_t& segment, Caps caps) RT_SAFE;
  [[nodiscard]] bool stop_at_wall(const PathMotion& from, std::size_t segment,
                                  const BrakingRange& range, Caps caps) RT_SAFE;
  void stop(const PathMotion& from, std::size_t segment, const BrakingRange& range, Caps caps)
      RT_SAFE;
  [[nodiscard]] RestPlan& draft() RT_SAFE { return plans_[1 - current_]; }

  double cycle_s_;
  double stop_limits_;
  PathSight sight_;
  std::array<RestPlan, 2> plans_{};  // the one being run, and a draft
  std::size_t current_ = 0;
  bool has_plan_ = false;
  Caps plan_caps_ = Caps::hard;  // under which the plan was found
  FeedControl plan_control_;
  Caps draft_caps_ = Caps::hard;
  PathSight::Reach reach_;
  double override_max_ = unlimited;
  PathBrake brake_;
};

}  // namespace stanok::motion
