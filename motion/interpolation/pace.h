// Pace: how fast the time of a committed plan passes under an override.
//
// A plan that uses the limits of its axes to the full leaves no room to be changed by speed alone.
// It can be run more slowly: at the pace p = d(tau)/dt the path moves by
//   v = p v_c,   a = p^2 a_c + p' v_c,   j = p^3 j_c + 3 p p' a_c + p'' v_c
// of the plan's v_c, a_c, j_c at its own time tau. With P, Q, R and u of PaceLimits every axis
// keeps its limits while
//   u p^2 + |p'| P <= 1,   u p^3 + 3 p |p'| R + |p''| Q <= 1,
// which the steps of this file do at any p of 0 to 1 (docs/developer/motion.md#pace). A lower
// override is never faster than a higher one. Real-time.
#pragma once

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

struct Pace {
  double rate = 1.0;    // p
  double change = 0.0;  // p', 1/s

  [[nodiscard]] bool is_nominal() const RT_SAFE { return rate == 1.0 && change == 0.0; }
  [[nodiscard]] bool rests() const RT_SAFE { return rate == 0.0 && change == 0.0; }
};

// Whether the steps of this file can go on from a pace: its change can be taken away again before
// the limits are broken or the time turns back, with `time`, a cycle, to spare.
[[nodiscard]] bool goes_on_from(const Pace& pace, const PaceLimits& limits, double time) RT_SAFE;

// In which a change of the pace is taken away, from the largest that the limits allow.
[[nodiscard]] double settling_time(const PaceLimits& limits) RT_SAFE;

// p'' is constant over a step; the plan's time advances by `advance`.
struct PaceStep {
  Pace from;
  double second = 0.0;  // p'', 1/s^2
  Pace to;
  double advance = 0.0;  // s

  // The time within the step, 0 to `duration`, after which the plan has advanced by `part` of it.
  [[nodiscard]] double time_of(double part, double duration) const RT_SAFE;
  [[nodiscard]] Pace after(double time) const RT_SAFE;
};

// The step of `time` towards the rate `target`, 0 to 1, as fast as the limits allow. `ahead`: the
// highest limits of here and of what comes within twice the settling time; the change comes within
// what they allow before.
[[nodiscard]] PaceStep step_pace(const Pace& from, double target, const PaceLimits& limits,
                                 const PaceLimits& ahead, double time) RT_SAFE;

// The step of `time` at an even pace, one whose rate does not change.
[[nodiscard]] PaceStep keep_pace(const Pace& pace, double time) RT_SAFE;

// What the path does where the plan is in the state `planned`.
[[nodiscard]] PathMotion at_pace(const PathMotion& planned, const Pace& pace, double second)
    RT_SAFE;

}  // namespace stanok::motion
