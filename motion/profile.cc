#include "motion/profile.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
namespace {

// Largest x found in [low, high] with f(x) <= 0, for a growing f with f(low) <= 0: regula falsi
// with halved weights (Illinois), which keeps the root bracketed.
template <class Function>
double last_below(const Function& f, double low, double high, double tolerance) RT_SAFE {
  double f_low = f(low);
  double f_high = f(high);
  if (f_high <= 0.0) return high;
  for (int step = 0; step < 60 && f_low < -tolerance; ++step) {
    double x = high - f_high * (high - low) / (f_high - f_low);
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    if (!(x > low && x < high)) break;
    const double fx = f(x);
    if (fx > 0.0) {
      if (fx <= tolerance) {  // just above: the root lies a hair below
        const double below = x - (fx + tolerance) * (x - low) / (fx - f_low);
        if (below > low && f(below) <= 0.0) return below;
      }
      high = x;
      f_high = fx;
      f_low *= 0.5;
    } else {
      if (fx > -tolerance) return x;
      low = x;
      f_low = fx;
      f_high *= 0.5;
    }
  }
  return low;
}

// Part of a length to which roots are found; the rest of it is run at constant speed.
constexpr double length_tolerance = 1e-13;

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

double distance_from_slow_end(double low, double high, const RampLimits& limits, double v) RT_SAFE {
  const double peak = peak_acceleration(high - low, limits);
  const double rounding = 0.5 * peak * peak / limits.j;  // speed gained while the jerk acts
  if (v - low <= rounding) {
    const double t = std::sqrt(2.0 * std::max(v - low, 0.0) / limits.j);
    return low * t + limits.j * t * t * t / 6.0;
  }
  const double t_jerk = peak / limits.j;
  if (high - v < rounding) {
    const double t = std::sqrt(2.0 * std::max(high - v, 0.0) / limits.j);
    return ramp_distance(low, high, limits) - (high * t - limits.j * t * t * t / 6.0);
  }
  const double t = (v - low - rounding) / peak;
  return low * t_jerk + limits.j * t_jerk * t_jerk * t_jerk / 6.0 + (low + rounding) * t +
         0.5 * peak * t * t;
}

double reachable_speed(double v0, double distance, const RampLimits& limits) RT_SAFE {
  if (distance <= 0.0) return v0;
  // D >= dv^1.5 / sqrt(J) and D >= dv^2 / (2 A) bound the change from above.
  const double dv_max =
      std::min(std::cbrt(distance * distance * limits.j), std::sqrt(2.0 * distance * limits.a));
  const auto excess = [&](double v) { return ramp_distance(v0, v, limits) - distance; };
  return last_below(excess, v0, v0 + dv_max, length_tolerance * distance);
}

double peak_speed(double v0, double v1, double distance, const RampLimits& up,
                  const RampLimits& down, double v_max) RT_SAFE {
  const auto excess = [&](double v) {
    return ramp_distance(v0, v, up) + ramp_distance(v, v1, down) - distance;
  };
  return last_below(excess, std::max(v0, v1), v_max, length_tolerance * distance);
}

PathMotion motion_at(const Phase& phase, double t) RT_SAFE {
  return {.s = phase.s + t * (phase.v + t * (0.5 * phase.a + t * phase.j / 6.0)),
          .v = phase.v + t * (phase.a + t * 0.5 * phase.j),
          .a = phase.a + t * phase.j,
          .j = phase.j};
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
