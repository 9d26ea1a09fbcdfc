// Phases of the ways to rest (motion/threads/chain_brake.h).
#include "motion/threads/chain_brake.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/threads/section_limits.h"

namespace stanok::motion {

void ChainBrake::begin(const SpindleCoupling& coupling, double length) RT_SAFE {
  coupling_ = coupling;
  length_ = length;
}

// Coordinate of a way to rest: counts from its end, in the direction of travel.
ChainBrake::Approach ChainBrake::approach(double end, const PathMotion& from,
                                          const RampLimits& limits) const RT_SAFE {
  Approach approach;
  const double forward = from.v < 0.0 ? -1.0 : 1.0;
  const double j = limits.j;
  const PathMotion m{forward * (from.s - end), forward * from.v, forward * from.a, 0.0};
  approach.forward = forward;
  approach.ease = {
      .duration = std::abs(m.a) / j, .s = m.s, .v = m.v, .a = m.a, .j = m.a > 0.0 ? -j : j};
  const PathMotion eased = motion_at(approach.ease, approach.ease.duration);
  approach.ease.s_end = eased.s;
  approach.ease.v_end = eased.v;
  if (eased.v <= 0.0) return approach;
  for (const auto& [section, earliest] :
       {std::pair{coupling_.exit, forward * (coupling_.exit_begin - end)},
        std::pair{coupling_.chain, eased.s}}) {
    approach.limits = limits_of(section);
    approach.ramp_begin = -ramp_distance(eased.v, 0.0, approach.limits);
    approach.fits = approach.ramp_begin >= std::max(earliest, eased.s);
    if (approach.fits) break;
  }
  return approach;
}

bool ChainBrake::comes_to_rest_before(double end, const PathMotion& from,
                                      const RampLimits& limits) const RT_SAFE {
  const Approach way = approach(end, from, limits);
  return way.fits || (way.ease.v_end <= 0.0 && way.ease.s <= 0.0);
}

// The acceleration is taken away, the speed held, and ramped down to the very end: behind the last
// corner, or where there is no room for that with what the whole chain allows.
ChainBrake::WayToRest ChainBrake::way_to(double end, const PathMotion& from,
                                         const RampLimits& limits) const RT_SAFE {
  const Approach course = approach(end, from, limits);
  if (!course.fits) return shortest(from, limits);
  WayToRest way;
  const double v = course.ease.v_end;
  way.phases[way.size++] = course.ease;
  way.phases[way.size++] = {.duration = (course.ramp_begin - course.ease.s_end) / v,
                            .s = course.ease.s_end,
                            .v = v,
                            .s_end = course.ramp_begin,
                            .v_end = v};
  for (const Phase& phase : ramp_down(v, 0.0, 0.0, course.limits)) way.phases[way.size++] = phase;
  for (std::size_t k = 0; k < way.size; ++k) {
    Phase& phase = way.phases[k];
    phase.s = end + course.forward * phase.s;
    phase.s_end = end + course.forward * phase.s_end;
    phase.v *= course.forward;
    phase.v_end *= course.forward;
    phase.a *= course.forward;
    phase.j *= course.forward;
  }
  way.ends_chain = true;
  return way;
}

// Wherever it ends.
ChainBrake::WayToRest ChainBrake::shortest(const PathMotion& from, const RampLimits& limits)
    RT_SAFE {
  WayToRest way;
  for (const Phase& phase : change_speed(from, 0.0, limits)) way.phases[way.size++] = phase;
  return way;
}

void ChainBrake::brake_at(double end, const PathMotion& from, const RampLimits& limits) RT_SAFE {
  take(way_to(end, from, limits));
}

// Where the shortest way would end beyond the chain, the way to its end.
void ChainBrake::brake(const PathMotion& from, const RampLimits& limits) RT_SAFE {
  const WayToRest way = shortest(from, limits);
  const double s = way.size > 0 ? way.phases[way.size - 1].s_end : 0.0;
  if (s > length_) return brake_at(length_, from, limits);
  if (s < 0.0) return brake_at(0.0, from, limits);
  take(way);
}

void ChainBrake::take(const WayToRest& way) RT_SAFE {
  way_ = way;
  time_ = 0.0;
}

ChainBrake::Answer ChainBrake::advance(PathMotion& motion) RT_SAFE {
  time_ += cycle_s_;
  double t = time_;
  for (std::size_t k = 0; k < way_.size; ++k) {
    const Phase& phase = way_.phases[k];
    if (t < phase.duration) {
      motion = motion_at(phase, t);
      return Answer::moves;
    }
    t -= phase.duration;
  }
  motion = {.s = way_.size > 0 ? way_.phases[way_.size - 1].s_end : motion.s};
  return way_.ends_chain ? Answer::at_end_of_chain : Answer::at_rest;
}

}  // namespace stanok::motion
