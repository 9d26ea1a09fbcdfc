// Gains of the controller, and how it stays within its limits (motion/threads/course_controller.h).
#include "motion/threads/course_controller.h"

#include <algorithm>
#include <cmath>

#include "motion/threads/spindle_observer.h"

namespace stanok::motion {
namespace {

using kinematics::Jet;

// Frequency of the controller: that of the observer it follows.
constexpr double bandwidth = SpindleObserver::bandwidth;  // rad/s

constexpr double settled_lag = CourseController::lag_max / 4;

// The share of jerk and acceleration with which the controller takes a large difference away.
constexpr double taken_back = 0.5;

}  // namespace

// The controller answers a step of the encoder with its gain of s; three tenths of that are enough
// (measured with 256, 1,024 and 4,096 pulses at 1 to 16 turns/s and leads of 1 to 23 mm).
double jerk_to_follow(int encoder_pulses, double cycle_s) {
  constexpr double part = 0.3;
  const double p = 1.0 - std::exp(-bandwidth * cycle_s);
  return part * std::pow(p / cycle_s, 3) / encoder_pulses;
}

// Gains that lay the three poles of the sampled loop together at exp(-bandwidth * cycle), for a
// jerk that is constant within a cycle (docs/developer/motion.md#threads).
CourseController::CourseController(double cycle_s) : cycle_s_(cycle_s) {
  const double T = cycle_s;
  const double p = 1.0 - std::exp(-bandwidth * T);
  gain_s_ = p * p * p / (T * T * T);
  gain_v_ = p * p * (3.0 - p) / (T * T);
  gain_a_ = p * (3.0 - p * (1.5 - p / 3.0)) / T;
}

PathMotion CourseController::advance(const PathMotion& motion, const Jet& course,
                                     const RampLimits& limits, const SpeedRange& speeds) const
    RT_SAFE {
  const double wanted = jerk_towards(motion, course, limits);
  return motion_with_jerk(motion, jerk_allowed(motion, wanted, limits, speeds), cycle_s_);
}

// Where the course, which is that of the setpoint, was at the start of its cycle.
PathMotion CourseController::before(const Jet& course) const RT_SAFE {
  return motion_with_jerk({course.value, course.first, course.second}, course.third, -cycle_s_);
}

// The jerk over the cycle up to the setpoint: that of the course, and the controller's on the
// difference at the start of the cycle. Its loops lie in each other: what the path is off asks for
// a speed, that for an acceleration, that for a jerk. A difference so large that the jerk would be
// beyond the limits is taken away as the limits can, on the curves of constant jerk v^3 ~ s^2 and
// a^2 ~ v, else a chain of three integrators swings up.
double CourseController::jerk_towards(const PathMotion& motion, const Jet& course,
                                      const RampLimits& limits) const RT_SAFE {
  const PathMotion due = before(course);
  const double s = due.s - motion.s;
  const double by_s =
      std::min({gain_s_ / gain_v_ * std::abs(s), std::cbrt(4.5 * taken_back * limits.j * s * s),
                std::sqrt(2.0 * taken_back * limits.a * std::abs(s))});
  const double v = due.v - motion.v + std::copysign(by_s, s);
  const double by_v = std::min({gain_v_ / gain_a_ * std::abs(v),
                                std::sqrt(2.0 * taken_back * limits.j * std::abs(v)), limits.a});
  return course.third + gain_a_ * (due.a - motion.a + std::copysign(by_v, v));
}

// By what it is off now, and by what its speed is until the jerk has taken that away.
bool CourseController::is_settled(const PathMotion& motion, const Jet& course,
                                  const RampLimits& limits) const RT_SAFE {
  const double j = limits.j;
  const PathMotion due = before(course);
  const double ease = std::abs(due.a - motion.a) / j;
  const double speed = std::abs(due.v - motion.v) + 0.5 * j * ease * ease;
  const double time = ease + 2.0 * std::sqrt(speed / j);
  return std::abs(due.s - motion.s) + 0.5 * speed * time <= settled_lag;
}

// The jerk nearest to the one wanted that keeps jerk, acceleration, and the speed at which the
// acceleration can be gone.
double CourseController::jerk_allowed(const PathMotion& motion, double wanted,
                                      const RampLimits& limits, const SpeedRange& speeds) const
    RT_SAFE {
  const double low = std::max(-limits.j, (-limits.a - motion.a) / cycle_s_);
  const double high = std::min(limits.j, (limits.a - motion.a) / cycle_s_);
  const auto eased = [&](double j) RT_SAFE {
    const PathMotion next = motion_with_jerk(motion, j, cycle_s_);
    return eased_speed(next.v, next.a, limits.j);
  };
  double beyond = std::clamp(wanted, low, high);
  const double speed = eased(beyond);
  if (speeds.min <= speed && speed <= speeds.max) return beyond;
  const bool is_too_fast = speed > speeds.max;
  double kept = is_too_fast ? low : high;
  constexpr int halvings = 40;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (kept + beyond);
    const double v = eased(middle);
    ((is_too_fast ? v <= speeds.max : v >= speeds.min) ? kept : beyond) = middle;
  }
  return kept;
}

}  // namespace stanok::motion
