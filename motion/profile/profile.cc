#include "motion/profile/profile.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
namespace {

// A value is found when the next step of Newton's method is this part of it: its rounding.
constexpr double newton_settled = 1e-15;
constexpr int newton_steps_max = 60;

// The highest speed, at or just below `v` and not below `least`, that covers no more than
// `distance`: v itself does but for rounding.
template <class Covered>
double highest_within(double distance, const Covered& covered, double v, double least) RT_SAFE {
  for (double step = newton_settled * v; v > least && covered(v) > distance; step *= 2.0) {
    v = std::max(v - step, least);
  }
  return v;
}

double peak_acceleration(double dv, const RampLimits& limits) RT_SAFE {
  return std::min(limits.a, std::sqrt(dv * limits.j));
}

Phase phase_from(double s, double v, double a, double j, double duration) RT_SAFE {
  Phase phase{.duration = duration, .s = s, .v = v, .a = a, .j = j};
  const PathMotion end = motion_at(phase, duration);
  phase.s_end = end.s;
  phase.v_end = end.v;
  return phase;
}

// How much longer the ramp from `low` gets with its high speed: dD / dv, v > low.
double distance_gain(double low, double v, const RampLimits& limits) RT_SAFE {
  const double dv = v - low;
  const double duration = ramp_duration(low, v, limits);
  const double duration_gain =
      dv * limits.j <= limits.a * limits.a ? 0.5 * duration / dv : 1.0 / limits.a;
  return 0.5 * (duration + (low + v) * duration_gain);
}

// Change of speed of the ramp that covers `distance`, to rounding. With A = a, J = j:
//   up to dv = A^2 / J   D = (2 v0 + dv) sqrt(dv / J), a cubic for x = sqrt(dv / J), half the time:
//                        x^3 + 3 p x = 2 q, p = 2 v0 / 3J, q = D / 2J (Cardano's formula);
//   beyond it            D = (v0 + dv / 2) (A / J + dv / A), a quadratic for dv:
//                        (dv + v0 + r)^2 = (v0 - r)^2 + 2 A D, r = A^2 / 2J.
double speed_gain(double v0, double distance, const RampLimits& limits) RT_SAFE {
  const double r = 0.5 * limits.a * limits.a / limits.j;
  if (distance * limits.a > 4.0 * r * (v0 + r)) {
    const double root = std::sqrt((v0 - r) * (v0 - r) + 2.0 * limits.a * distance);
    return (2.0 * limits.a * distance - 4.0 * v0 * r) / (root + v0 + r);
  }
  const double p = 2.0 * v0 / (3.0 * limits.j);
  const double q = 0.5 * distance / limits.j;
  const double u = std::cbrt(q + std::sqrt(q * q + p * p * p));
  const double w = p / u;
  const double x = 2.0 * q / (u * u + p + w * w);
  return limits.j * x * x;
}

}  // namespace

RampLimits lower_of(const RampLimits& one, const RampLimits& other) RT_SAFE {
  return {.a = std::min(one.a, other.a), .j = std::min(one.j, other.j)};
}

double ramp_duration(double v0, double v1, const RampLimits& limits) RT_SAFE {
  const double dv = std::abs(v1 - v0);
  if (dv * limits.j <= limits.a * limits.a) return 2.0 * std::sqrt(dv / limits.j);
  return limits.a / limits.j + dv / limits.a;
}

double ramp_distance(double v0, double v1, const RampLimits& limits) RT_SAFE {
  return 0.5 * (v0 + v1) * ramp_duration(v0, v1, limits);
}

RampCourse::RampCourse(double low, double high, const RampLimits& limits) RT_SAFE
    : low_(low),
      high_(high),
      jerk_(limits.j),
      length_(ramp_distance(low, high, limits)),
      peak_(peak_acceleration(high - low, limits)),
      rounding_(0.5 * peak_ * peak_ / limits.j) {
  const double t = peak_ / jerk_;
  rounded_ = low_ * t + jerk_ * t * t * t / 6.0;
}

double RampCourse::distance_to(double v) const RT_SAFE {
  if (v - low_ <= rounding_) {
    const double t = std::sqrt(2.0 * std::max(v - low_, 0.0) / jerk_);
    return low_ * t + jerk_ * t * t * t / 6.0;
  }
  if (high_ - v < rounding_) {
    const double t = std::sqrt(2.0 * std::max(high_ - v, 0.0) / jerk_);
    return length_ - (high_ * t - jerk_ * t * t * t / 6.0);
  }
  const double t = (v - low_ - rounding_) / peak_;
  return rounded_ + (low_ + rounding_) * t + 0.5 * peak_ * t * t;
}

double reachable_speed(double v0, double distance, const RampLimits& limits) RT_SAFE {
  if (distance <= 0.0) return v0;
  const auto covered = [&](double v) RT_SAFE { return ramp_distance(v0, v, limits); };
  return highest_within(distance, covered, v0 + speed_gain(v0, distance, limits), v0);
}

// Newton's method, kept between speeds that are known to be too low and too high.
double peak_speed(double v0, double v1, double distance, const RampLimits& up,
                  const RampLimits& down, double v_max) RT_SAFE {
  const auto covered = [&](double v) RT_SAFE {
    return ramp_distance(v0, v, up) + ramp_distance(v, v1, down);
  };
  if (covered(v_max) <= distance) return v_max;
  const double least = std::max(v0, v1);
  const double room = distance - covered(least);
  if (room <= 0.0) return least;
  double low = least;
  double high = v_max;
  double v = least + speed_gain(least, 0.5 * room, lower_of(up, down));
  for (int step = 0; step < newton_steps_max && v > low && v < high; ++step) {
    const double excess = covered(v) - distance;
    (excess > 0.0 ? high : low) = v;
    const double newton = v - excess / (distance_gain(v0, v, up) + distance_gain(v1, v, down));
    if (std::abs(newton - v) <= newton_settled * v) break;
    v = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return highest_within(distance, covered, v, least);
}

PathMotion motion_at(const Phase& phase, double t) RT_SAFE {
  return {.s = phase.s + t * (phase.v + t * (0.5 * phase.a + t * phase.j / 6.0)),
          .v = phase.v + t * (phase.a + t * 0.5 * phase.j),
          .a = phase.a + t * phase.j,
          .j = phase.j};
}

double time_at(const Phase& phase, double s) RT_SAFE {
  double low = 0.0;
  double high = phase.duration;
  double t = phase.duration * (s - phase.s) / (phase.s_end - phase.s);
  for (int step = 0; step < newton_steps_max && low < t && t < high; ++step) {
    const PathMotion motion = motion_at(phase, t);
    (motion.s < s ? low : high) = t;
    const double newton = motion.v > 0.0 ? t - (motion.s - s) / motion.v : high;
    if (std::abs(newton - t) <= newton_settled * t) break;
    t = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return t;
}

PhaseRun ramp_up(double s0, double v0, double v1, const RampLimits& limits) RT_SAFE {
  PhaseRun run;
  const double dv = v1 - v0;
  if (dv <= 0.0) return run;
  const double peak = peak_acceleration(dv, limits);
  const double t_jerk = peak / limits.j;
  const double t_constant = std::max(dv / peak - t_jerk, 0.0);
  run.add(phase_from(s0, v0, 0.0, limits.j, t_jerk));
  if (t_constant > 0.0) {
    run.add(phase_from(run[0].s_end, run[0].v_end, peak, 0.0, t_constant));
  }
  const Phase& before = run[run.size() - 1];
  Phase last = phase_from(before.s_end, before.v_end, peak, -limits.j, t_jerk);
  last.v_end = v1;
  run.add(last);
  return run;
}

PhaseRun ramp_down(double v0, double s1, double v1, const RampLimits& limits) RT_SAFE {
  // Backwards in time the ramp is one up from v1; s runs the other way and the jerk changes sign.
  const PhaseRun mirrored = ramp_up(0.0, v1, v0, limits);
  PhaseRun run;
  for (std::size_t k = mirrored.size(); k > 0; --k) {
    const Phase& back = mirrored[k - 1];
    const double a_end = back.a + back.j * back.duration;
    run.add({.duration = back.duration,
             .s = s1 - back.s_end,
             .v = back.v_end,
             .a = k == mirrored.size() ? 0.0 : -a_end,
             .j = back.j,
             .s_end = s1 - back.s,
             .v_end = back.v});
  }
  return run;
}

PhaseRun change_speed(const PathMotion& from, double v_target, const RampLimits& limits) RT_SAFE {
  PhaseRun run;
  const double direction = v_target >= eased_speed(from.v, from.a, limits.j) ? 1.0 : -1.0;
  const double a = direction * from.a;  // all further in the direction of the change
  const double dv = direction * (v_target - from.v);
  double peak = std::sqrt(std::max(limits.j * dv + 0.5 * a * a, 0.0));
  double t_constant = 0.0;
  if (peak > limits.a) {
    peak = limits.a;
    const double dv_first =
        (a > peak ? a * a - peak * peak : peak * peak - a * a) / (2.0 * limits.j);
    const double dv_jerk = dv_first + 0.5 * peak * peak / limits.j;
    t_constant = std::max(dv - dv_jerk, 0.0) / peak;
  }
  const double t_first = std::abs(peak - a) / limits.j;
  double s = from.s;
  double v = from.v;
  const auto append = [&](double a_start, double j, double duration) {
    if (duration <= 0.0) return;
    run.add(phase_from(s, v, direction * a_start, direction * j, duration));
    s = run[run.size() - 1].s_end;
    v = run[run.size() - 1].v_end;
  };
  append(a, peak >= a ? limits.j : -limits.j, t_first);
  append(peak, 0.0, t_constant);
  append(peak, -limits.j, peak / limits.j);
  if (run.size() > 0) run[run.size() - 1].v_end = v_target;
  return run;
}

double eased_speed(double v, double a, double j) RT_SAFE {
  return v + 0.5 * a * std::abs(a) / j;
}

}  // namespace stanok::motion
