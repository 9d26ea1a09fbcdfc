// CourseController: leads the path onto the course that a spindle gives, by the jerk of each cycle.
//
// A controller of third order on a chain of three integrators, its poles where those of the
// spindle's observer lie (docs/developer/motion.md#threads). The course is a jet over time at the
// instant of the setpoint. Thread: the cycle. Owner: SynchronousRun. Invariants: it keeps nothing
// of a chain; no cycle leaves the limits and the range of speeds that it is given.
#pragma once

#include "base/rt_safe.h"
#include "kinematics/jet.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

// Jerk along the chain, in turns/s^3, that the path needs to follow a spindle through the steps of
// its encoder; with less it comes off the law.
[[nodiscard]] double jerk_to_follow(int encoder_pulses, double cycle_s);

class CourseController {
 public:
  // Of the path, along s.
  struct SpeedRange {
    double min = 0.0;
    double max = 0.0;
  };

  explicit CourseController(double cycle_s);

  // The motion after one cycle towards the course.
  [[nodiscard]] PathMotion advance(const PathMotion& motion, const kinematics::Jet& course,
                                   const RampLimits& limits, const SpeedRange& speeds) const
      RT_SAFE;
  // The jerk that the course asks for, within the limits or not.
  [[nodiscard]] double jerk_towards(const PathMotion& motion, const kinematics::Jet& course,
                                    const RampLimits& limits) const RT_SAFE;
  // Whether the path, with these limits, comes onto the course and leaves it on its way by no more
  // than a part of what may be.
  [[nodiscard]] bool is_settled(const PathMotion& motion, const kinematics::Jet& course,
                                const RampLimits& limits) const RT_SAFE;

  static constexpr double lag_max = 1.0 / 50;  // turns off the law

 private:
  [[nodiscard]] PathMotion before(const kinematics::Jet& course) const RT_SAFE;
  [[nodiscard]] double jerk_allowed(const PathMotion& motion, double wanted,
                                    const RampLimits& limits, const SpeedRange& speeds) const
      RT_SAFE;

  double cycle_s_;
  double gain_s_;  // jerk by s, v, a
  double gain_v_;
  double gain_a_;
};

}  // namespace stanok::motion
