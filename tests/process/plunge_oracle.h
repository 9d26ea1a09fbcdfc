// A plunge cycle by another scheme than process/grinding: Runge-Kutta of fourth order for the
// spring, the surface as a ring of its own step, the force at the state as it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "process/grinding/boundary.h"
#include "process/grinding/infeed_law.h"

namespace stanok::testing {

struct OraclePlunge {
  double time_s = 0.0;
  double highest_mm = 0.0;  // what is left of the allowance there, at the end
  double lowest_mm = 0.0;
  double burn_ratio = 0.0;        // greatest Q/L
  double deflection_ratio = 0.0;  // greatest Q/Q_max behind four revolutions
};

// `watch`: time, X and force after each step. The law, then the wheel stands for some revolutions.
// The steps of a revolution are chosen so that the spring is resolved.
// One integrator, read beside its equations.
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
inline OraclePlunge run_plunge(const process::GrindingProcess& p, const process::InfeedLaw& law,
                               double spark_out_revolutions, int steps_per_turn = 0,
                               const std::function<void(double, double, double)>& watch = {}) {
  const double turn_s = 60.0 / p.part_speed_rpm;
  const double m = p.mass_kg / 1000.0;            // N s2/mm
  const double b = p.damping_n_s_per_m / 1000.0;  // N s/mm
  const double C = p.stiffness_n_per_m / 1000.0;  // N/mm
  if (steps_per_turn == 0) {
    const double fast_s = std::min(1.0 / std::sqrt(C / m), m / b);
    steps_per_turn = std::max(2500, static_cast<int>(std::ceil(turn_s / (0.2 * fast_s))));
  }
  const double dt = turn_s / steps_per_turn;
  const double R =
      p.removal == process::RemovalForm::triangle
          ? p.part_radius_mm * p.wheel_radius_mm / (p.part_radius_mm + p.wheel_radius_mm)
          : p.part_radius_mm;
  const double V = 2.0 * std::numbers::pi * p.part_radius_mm * p.part_speed_rpm / 1000.0;
  const double K = p.force_factor * p.width_mm;
  const double allowance = law.front().x_mm;
  std::vector<double> depth(static_cast<std::size_t>(steps_per_turn), 0.0);
  // Time of the law, row by row.
  double law_s = 0.0;
  for (std::size_t k = 0; k + 1 < law.size(); ++k) {
    const double way = law[k].x_mm - law[k + 1].x_mm;
    const double v0 = law[k].feed_mm_per_s;
    const double v1 = law[k + 1].feed_mm_per_s;
    if (way > 0.0) law_s += v0 == v1 ? way / v0 : way * std::log(v1 / v0) / (v1 - v0);
  }
  const double Q_max = std::pow(C * p.deflection_max_mm / K, 1.0 / p.force_exponent) / V;
  // The burn line: straight, or through its points.
  const auto line = [&](double H) {
    double H0 = 0.0;
    double Q0 = p.removal_end_mm2_per_rad;
    for (const process::BurnPoint& point : p.burn_curve) {
      const double H1 = point.allowance_mm;
      const double Q1 = point.removal_mm2_per_rad;
      if (H <= H1) return Q0 + (Q1 - Q0) * (std::max(H, 0.0) - H0) / (H1 - H0);
      H0 = H1;
      Q0 = Q1;
    }
    return Q0 + (Q_max - Q0) * (std::max(H, 0.0) - H0) / (p.critical_allowance_mm - H0);
  };
  const double end_s = law_s + spark_out_revolutions * turn_s;
  const auto steps = static_cast<long>(std::llround(end_s / dt));
  double x = allowance;
  double y = 0.0;
  double v = 0.0;
  std::size_t row = 0;
  OraclePlunge result;
  for (long step = 0; step < steps; ++step) {
    const std::size_t angle = static_cast<std::size_t>(step % steps_per_turn);
    const double surface = depth[angle];
    // The way of a step, over rows that end in it.
    double rest = dt;
    while (rest > 0.0 && row + 1 < law.size()) {
      const double x1 = law[row + 1].x_mm;
      const double v0 = law[row].feed_mm_per_s;
      const double v1 = law[row + 1].feed_mm_per_s;
      const double length = law[row].x_mm - x1;
      if (length <= 0.0 || x <= x1) {
        ++row;
        continue;
      }
      const double here = v0 + (v1 - v0) * (law[row].x_mm - x) / length;
      const double slope = (v1 - v0) / length;  // over the way gone
      const double to_end = slope == 0.0 ? (x - x1) / here : std::log(v1 / here) / slope;
      if (to_end <= rest) {
        x = x1;
        rest -= to_end;
        ++row;
        continue;
      }
      x -= slope == 0.0 ? here * rest : here * std::expm1(slope * rest) / slope;
      rest = 0.0;
    }
    const double rigid = allowance - x;
    const auto force = [&](double deflection) {
      const double a = std::max(0.0, rigid - deflection - surface);
      return K * std::pow(R * a * V, p.force_exponent);
    };
    const auto acceleration = [&](double at, double speed) {
      return (force(at) - b * speed - C * at) / m;
    };
    const double k1y = v, k1v = acceleration(y, v);
    const double k2y = v + 0.5 * dt * k1v, k2v = acceleration(y + 0.5 * dt * k1y, k2y);
    const double k3y = v + 0.5 * dt * k2v, k3v = acceleration(y + 0.5 * dt * k2y, k3y);
    const double k4y = v + dt * k3v, k4v = acceleration(y + dt * k3y, k4y);
    y += dt / 6.0 * (k1y + 2.0 * k2y + 2.0 * k3y + k4y);
    v += dt / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
    const double layer = std::max(0.0, rigid - y - surface);
    depth[angle] += layer;
    if (watch) watch((static_cast<double>(step) + 1.0) * dt, x, force(y));
    const double Q = R * layer;
    const double H = x + y;
    result.burn_ratio = std::max(result.burn_ratio, Q / line(H));
    if (static_cast<double>(step + 1) * dt > 4.0 * turn_s)
      result.deflection_ratio = std::max(result.deflection_ratio, Q / Q_max);
  }
  result.time_s = static_cast<double>(steps) * dt;
  result.highest_mm = allowance - *std::ranges::min_element(depth);
  result.lowest_mm = allowance - *std::ranges::max_element(depth);
  return result;
}

}  // namespace stanok::testing
