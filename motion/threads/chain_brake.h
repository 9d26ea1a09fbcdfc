// ChainBrake: ways to rest within a chain that a spindle leads, and the one that is being run.
//
// Such a way takes the acceleration off, holds the speed and ramps it down to the very end of the
// chain, behind the last corner with the limits there, or, where the path is to stand as soon as
// may be, brakes wherever that ends. They run by time: the spindle is not followed any more.
// Thread: the cycle. Owner: SynchronousRun. Invariant: a way ends at rest, within the chain as long
// as a way to its end was known.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class ChainBrake {
 public:
  explicit ChainBrake(double cycle_s) : cycle_s_(cycle_s) {}

  void begin(const SpindleCoupling& coupling, double length) RT_SAFE;
  [[nodiscard]] double length() const RT_SAFE { return length_; }  // of the chain

  // Whether a way to rest at `end` is known from there; a path that is about to stand comes to rest
  // without a ramp.
  [[nodiscard]] bool comes_to_rest_before(double end, const PathMotion& from,
                                          const RampLimits& limits) const RT_SAFE;

  // From the next cycle on: to rest at `end`, or where no way there is known, wherever it ends.
  void brake_at(double end, const PathMotion& from, const RampLimits& limits) RT_SAFE;
  // From the next cycle on: to rest at once, but within the chain.
  void brake(const PathMotion& from, const RampLimits& limits) RT_SAFE;

  enum class Answer : std::uint8_t { moves, at_rest, at_end_of_chain };
  // One cycle on the way, from `motion` on.
  [[nodiscard]] Answer advance(PathMotion& motion) RT_SAFE;

 private:
  struct WayToRest {
    std::array<Phase, 2 + PhaseRun::capacity> phases{};
    std::size_t size = 0;
    bool ends_chain = false;
  };
  // The last ways to rest before an end; s counts from there in the direction of travel.
  struct Approach {
    double forward = 1.0;
    Phase ease;               // takes the acceleration away
    bool fits = false;        // what follows is known
    double ramp_begin = 0.0;  // of the ramp to rest, with these limits
    RampLimits limits;
  };
  [[nodiscard]] Approach approach(double end, const PathMotion& from,
                                  const RampLimits& limits) const RT_SAFE;
  [[nodiscard]] WayToRest way_to(double end, const PathMotion& from, const RampLimits& limits) const
      RT_SAFE;
  [[nodiscard]] static WayToRest shortest(const PathMotion& from, const RampLimits& limits) RT_SAFE;
  void take(const WayToRest& way) RT_SAFE;

  double cycle_s_;
  SpindleCoupling coupling_;
  double length_ = 0.0;
  WayToRest way_;  // the current one
  double time_ = 0.0;
};

}  // namespace stanok::motion
