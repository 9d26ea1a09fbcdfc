// Symbols: h step, y deflection, a layer, c a^alpha force of the cut (c of the layer in mm).
//
// Average acceleration makes of m y'' + b y' + C y = P the equation K y_1 = P_1 + f, with
// K = C + 2 b/h + 4 m/h^2 and f what the state before contributes.
#include "process/grinding/elastic_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stanok::process {
namespace {

constexpr double n_per_mm = 1e-3;  // of a value per m

// Newton's method on a convex rising function: every step after the first comes from the right and
// falls towards the root. Its digits double: a step of 1e-5 leaves an error of 1e-10. The bound on
// their number is never reached.
constexpr int newton_steps_max = 60;
constexpr double relative_step_last = 1e-5;

}  // namespace

ElasticSystem::ElasticSystem(const GrindingProcess& process, double time_step_s)
    : force_(process),
      exponent_inverse_(1.0 / process.force_exponent),
      mass_(process.mass_kg * n_per_mm),
      damping_(process.damping_n_s_per_m * n_per_mm),
      step_s_(time_step_s),
      resistance_(process.stiffness_n_per_m * n_per_mm + 2.0 * damping_ / step_s_ +
                  4.0 * mass_ / (step_s_ * step_s_)) {}

// c a^alpha + K a = K a_rigid - f in u = a^alpha: c u + K u^(1/alpha), convex as alpha <= 1. Begins
// where the last two steps point to.
double ElasticSystem::balanced_layer_mm(double free_force_n) {
  const double before = std::exchange(power_before_, power_);
  if (free_force_n <= 0.0) {
    power_ = 0.0;
    return 0.0;
  }
  const double u_max = free_force_n / force_.factor_of_layer();
  double u = std::min(2.0 * power_ - before, u_max);
  if (u <= 0.0) u = power_ > 0.0 ? power_ : u_max;
  double layer = 0.0;
  for (int k = 0; k < newton_steps_max; ++k) {
    layer = std::pow(u, exponent_inverse_);
    const double value = force_.factor_of_layer() * u + resistance_ * layer - free_force_n;
    const double slope = force_.factor_of_layer() + resistance_ * exponent_inverse_ * layer / u;
    const double next = std::min(u - value / slope, u_max);
    const double change = next / u - 1.0;
    u = next;
    layer *= 1.0 + exponent_inverse_ * change;  // u^(1/alpha), to first order
    if (std::abs(change) <= relative_step_last) break;
  }
  power_ = u;
  return layer;
}

double ElasticSystem::advance(double rigid_layer_mm) {
  const double h = step_s_;
  const double inertia = mass_ * (4.0 / (h * h) * y_ + 4.0 / h * dy_ + ddy_);
  const double from_before = inertia + damping_ * (2.0 / h * y_ + dy_);  // f, N
  const double layer = balanced_layer_mm(resistance_ * rigid_layer_mm - from_before);
  force_n_ = layer > 0.0 ? force_.factor_of_layer() * power_ : 0.0;
  const double y = (force_n_ + from_before) / resistance_;
  const double dy = 2.0 / h * (y - y_) - dy_;
  ddy_ = 4.0 / (h * h) * (y - y_ - h * dy_) - ddy_;
  dy_ = dy;
  y_ = y;
  return layer;
}

}  // namespace stanok::process
