#include "motion/time_optimum/optimum_phases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/path/sampling.h"
#include "motion/profile/profile.h"

namespace stanok::motion {
namespace {

EndState state_of(const SquaredSpeed& b) {
  return {.v = std::sqrt(b.value), .a = 0.5 * b.first};
}

// Half the duration of an interval: h = t (v0 + v1) + t^2 (a0 - a1) / 3.
double half_duration(double h, const EndState& from, const EndState& to) {
  const double sum = from.v + to.v;
  return 2.0 * h / (sum + std::sqrt(sum * sum + 4.0 * h * (from.a - to.a) / 3.0));
}

using Weights = LimitGrid::Weights;

AxisRates rates_between(const LimitGrid& grid, std::size_t interval, std::size_t axis,
                        const Weights& weights) {
  AxisRates sum;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const AxisRates& r = grid.rates(interval, static_cast<LimitGrid::Place>(i))[axis];
    sum.velocity += weights[i] * r.velocity;
    sum.tangent += weights[i] * r.tangent;
    sum.curvature += weights[i] * r.curvature;
    sum.thrust += weights[i] * r.thrust;
    sum.bend += weights[i] * r.bend;
    sum.aberrancy += weights[i] * r.aberrancy;
  }
  return sum;
}

// Places at which a phase is proved, evenly in time.
constexpr std::size_t proved = 5;
using Values = std::array<double, proved>;

// At an end, or between them where a = 0.
double highest_speed_of_phase(const Phase& phase, const PathMotion& end) {
  if (phase.a > 0.0 && end.a < 0.0) return phase.v - 0.5 * phase.a * phase.a / phase.j;
  return std::max(phase.v, end.v);
}

PhaseUse use_of_phase(const LimitGrid& grid, std::size_t interval, double s0, const Phase& phase) {
  const double length = grid.length(interval);
  std::array<PathMotion, proved> motion;
  std::array<Weights, proved> weights;
  for (std::size_t i = 0; i < proved; ++i) {
    motion[i] = motion_at(phase, phase.duration * static_cast<double>(i) / (proved - 1));
    weights[i] = LimitGrid::weights_at(std::clamp((motion[i].s - s0) / length, 0.0, 1.0));
  }
  const double v_max = highest_speed_of_phase(phase, motion.back());
  PhaseUse use{.speed = v_max * v_max / grid.top(interval)};
  for (std::size_t k = 0; k < grid.axes(); ++k) {
    Values acceleration;
    Values jerk;
    Values velocity;
    Values thrust;
    Values coupling;
    for (std::size_t i = 0; i < proved; ++i) {
      const AxisRates r = rates_between(grid, interval, k, weights[i]);
      const auto& [s, v, a, j] = motion[i];
      acceleration[i] = r.curvature * v * v + r.tangent * a;
      jerk[i] = v * (r.aberrancy * v * v + 3.0 * r.bend * a) + r.thrust * j;
      velocity[i] = r.tangent * v;
      thrust[i] = r.thrust * v;
      coupling[i] = r.bend * v * v + r.thrust * a;
    }
    use.include({.force = std::max(largest_with_margin(acceleration), largest_with_margin(jerk)),
                 .velocity = largest_with_margin(velocity),
                 .thrust = largest_with_margin(thrust),
                 .coupling = largest_with_margin(coupling)});
  }
  return use;
}

// The least number of single precision that is not below.
float rounded_up(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

}  // namespace

void append_phases(const LimitGrid& grid, const SpeedSpline& spline, double s0,
                   std::vector<Phase>& phases) {
  for (std::size_t m = 0; m < grid.size(); ++m) {
    const EndState from = state_of(spline.at(m, LimitGrid::start));
    const EndState to = state_of(spline.at(m, LimitGrid::end));
    const double t = half_duration(grid.length(m), from, to);
    const double j0 = (to.v - from.v) / (t * t) - (1.5 * from.a + 0.5 * to.a) / t;
    const double j1 = (to.a - from.a) / t - j0;
    const PathMotion half = motion_at({.s = s0, .v = from.v, .a = from.a, .j = j0}, t);
    const double s1 = s0 + grid.length(m);
    phases.push_back({.duration = t,
                      .s = s0,
                      .v = from.v,
                      .a = from.a,
                      .j = j0,
                      .s_end = half.s,
                      .v_end = half.v});
    phases.push_back({.duration = t,
                      .s = half.s,
                      .v = half.v,
                      .a = half.a,
                      .j = j1,
                      .s_end = s1,
                      .v_end = to.v});
    s0 = s1;
  }
}

void PhaseUse::include(const PhaseUse& other) {
  speed = std::max(speed, other.speed);
  force = std::max(force, other.force);
  velocity = std::max(velocity, other.velocity);
  thrust = std::max(thrust, other.thrust);
  coupling = std::max(coupling, other.coupling);
}

PaceLimits PhaseUse::pace_limits() const {
  return {.use = rounded_up(force),
          .velocity = rounded_up(velocity),
          .thrust = rounded_up(thrust),
          .coupling = rounded_up(coupling)};
}

PhaseUse use_of(const LimitGrid& grid, std::size_t interval, const Phase& first,
                const Phase& second) {
  PhaseUse use = use_of_phase(grid, interval, first.s, first);
  use.include(use_of_phase(grid, interval, first.s, second));
  return use;
}

}  // namespace stanok::motion
