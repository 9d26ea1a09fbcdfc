#include "plant/cutting/self_oscillation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::plant {
namespace {

// The seed that vibration begins from.
constexpr double seed_um = 0.01;

// Far beyond its amplitude the mass creeps back: critically damped.
constexpr double damping_max = 1.0;

}  // namespace

double SelfOscillation::acceleration(double x_um, double v, double force_n,
                                     Engagement engagement) const RT_SAFE {
  constexpr double um_per_m = 1e6;
  const double omega = 2.0 * std::numbers::pi * config_.frequency_hz;
  const double part = x_um / config_.amplitude_um;
  const double damping =
      engagement == Engagement::in_cut
          ? std::min(-config_.negative_damping * (1.0 - 4.0 * part * part), damping_max)
          : config_.negative_damping;
  return um_per_m * force_n / config_.mass_kg - 2.0 * damping * omega * v - omega * omega * x_um;
}

void SelfOscillation::advance(double force_n, Engagement engagement, double dt_s) RT_SAFE {
  if (config_.amplitude_um <= 0.0) return;
  const bool is_at_rest = std::abs(x_um_) < seed_um && std::abs(v_) < seed_um;
  if (engagement == Engagement::out_of_cut && is_at_rest) return;
  const double h = dt_s;
  const auto a = [&](double x, double v)
                     RT_SAFE { return acceleration(x, v, force_n, engagement); };
  const double v1 = v_;
  const double a1 = a(x_um_, v_);
  const double v2 = v_ + 0.5 * h * a1;
  const double a2 = a(x_um_ + 0.5 * h * v1, v2);
  const double v3 = v_ + 0.5 * h * a2;
  const double a3 = a(x_um_ + 0.5 * h * v2, v3);
  const double v4 = v_ + h * a3;
  const double a4 = a(x_um_ + h * v3, v4);
  x_um_ += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
  v_ += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

}  // namespace stanok::plant
