// Closed-form S-curves: speed changes along the path under bounded acceleration and jerk.
//
// A *ramp* changes the speed from v0 to v1 with a = 0 at both ends. With dv = |v1 - v0| it lasts
//   T = 2 sqrt(dv / J)        while the peak acceleration sqrt(dv J) stays below A, else
//   T = A / J + dv / A,
// and, being symmetric in time, covers D = (v0 + v1) / 2 * T (docs/developer/motion.md#profile).
// Units: mm (or deg) and s. Everything here is pure and RT_SAFE.
#pragma once

#include <array>
#include <cstddef>

#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::motion {

// Bounds of the tangential acceleration and jerk of a ramp; both > 0 and finite.
struct RampLimits {
  double a = 0.0;
  double j = 0.0;
};

[[nodiscard]] RampLimits lower_of(const RampLimits& one, const RampLimits& other) RT_SAFE;

[[nodiscard]] double ramp_duration(double v0, double v1, const RampLimits& limits) RT_SAFE;
[[nodiscard]] double ramp_distance(double v0, double v1, const RampLimits& limits) RT_SAFE;

// Where the ramp between two speeds has which speed. Ramps up and down are mirror images, so it
// serves both: distances count from the slow end.
class RampCourse {
 public:
  RampCourse(double low, double high, const RampLimits& limits) RT_SAFE;

  [[nodiscard]] double high() const RT_SAFE { return high_; }
  [[nodiscard]] double length() const RT_SAFE { return length_; }
  // low <= v <= high
  [[nodiscard]] double distance_to(double v) const RT_SAFE;

 private:
  double low_;
  double high_;
  double jerk_;
  double length_;
  double peak_;      // acceleration
  double rounding_;  // speed gained while the jerk acts
  double rounded_;   // distance covered until then
};

// The highest speed that a ramp from v0 attains within `distance`; by symmetry also the highest
// speed from which a ramp comes down to v0 in it.
[[nodiscard]] double reachable_speed(double v0, double distance, const RampLimits& limits) RT_SAFE;

// The highest top speed, at most v_max, of a ramp from v0 up to it and another down to v1 that
// together fit into `distance`. Needs max(v0, v1) <= v_max and room for the ramp from v0 to v1.
[[nodiscard]] double peak_speed(double v0, double v1, double distance, const RampLimits& up,
                                const RampLimits& down, double v_max) RT_SAFE;

// State along the path.
struct PathMotion {
  double s = 0.0;
  double v = 0.0;
  double a = 0.0;
  double j = 0.0;
};

[[nodiscard]] inline bool is_at_rest(const PathMotion& motion) RT_SAFE {
  return motion.v == 0.0 && motion.a == 0.0;
}

// The state `t` later, with that jerk from now on; t < 0: earlier.
[[nodiscard]] inline PathMotion motion_with_jerk(const PathMotion& motion, double jerk, double t)
    RT_SAFE {
  return {.s = motion.s + t * (motion.v + t * (0.5 * motion.a + t * jerk / 6.0)),
          .v = motion.v + t * (motion.a + 0.5 * t * jerk),
          .a = motion.a + t * jerk,
          .j = jerk};
}

// State within a phase `t` after its start, 0 <= t <= duration.
[[nodiscard]] PathMotion motion_at(const Phase& phase, double t) RT_SAFE;

// Time after which a phase has come to `s`, which lies between its ends.
[[nodiscard]] double time_at(const Phase& phase, double s) RT_SAFE;

// A few phases one after another.
class PhaseRun {
 public:
  static constexpr std::size_t capacity = 3;
  void add(const Phase& phase) RT_SAFE { phases_[size_++] = phase; }
  [[nodiscard]] std::size_t size() const RT_SAFE { return size_; }
  [[nodiscard]] Phase& operator[](std::size_t index) RT_SAFE { return phases_[index]; }
  [[nodiscard]] const Phase& operator[](std::size_t index) const RT_SAFE { return phases_[index]; }
  [[nodiscard]] const Phase* begin() const RT_SAFE { return phases_.data(); }
  [[nodiscard]] const Phase* end() const RT_SAFE { return phases_.data() + size_; }

 private:
  std::array<Phase, capacity> phases_{};
  std::size_t size_ = 0;
};

// The ramp from (s0, v0) to v1 >= v0, evaluated forwards from its start.
[[nodiscard]] PhaseRun ramp_up(double s0, double v0, double v1, const RampLimits& limits) RT_SAFE;

// The ramp from v0 down to (s1, v1), v1 <= v0, evaluated backwards from its end, so that the end is
// exact.
[[nodiscard]] PhaseRun ramp_down(double v0, double s1, double v1, const RampLimits& limits) RT_SAFE;

// The fastest change from any (v, a) to (v_target, a = 0): up to three phases. An acceleration
// above the limit is first brought back to it at the limit of jerk.
[[nodiscard]] PhaseRun change_speed(const PathMotion& from, double v_target,
                                    const RampLimits& limits) RT_SAFE;

// Speed at which the acceleration `a` has gone when it is taken away at once: v + a |a| / (2 J).
[[nodiscard]] double eased_speed(double v, double a, double j) RT_SAFE;

}  // namespace stanok::motion
