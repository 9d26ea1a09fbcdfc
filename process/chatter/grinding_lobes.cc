#include "process/chatter/grinding_lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stanok::process {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
constexpr double lowest_seen = 0.5;  // of the lowest_seen natural frequency: G pushes back below it
constexpr double highest_seen = 3.0;          // of the highest_seen one
constexpr int grinding_steps_per_wave = 32;   // frequencies while a turn takes one wave more
constexpr int grinding_steps_per_width = 40;  // within the width of a resonance

double evened_out(double omega, double length_mm, double speed_mm_per_s) {
  const double x = omega * length_mm / (2.0 * speed_mm_per_s);
  return x < 1e-6 ? 1.0 : std::sin(x) / x;
}

// 1 / (1 - g e^(-i w T))
std::complex<double> met_again(double omega, double turn_s, double g) {
  return 1.0 / (1.0 - g * std::polar(1.0, -omega * turn_s));
}

}  // namespace

GrindingLobes::GrindingLobes(const CuttingProcess& process) : process_(process) {
  omega_from_ = process.modes_x.front().omega();
  omega_step_max_ = omega_from_;
  for (const VibrationMode& mode : process.modes_x) {
    omega_from_ = std::min(omega_from_, mode.omega());
    omega_to_ = std::max(omega_to_, mode.omega());
    omega_step_max_ =
        std::min(omega_step_max_, mode.damping * mode.omega() / grinding_steps_per_width);
  }
  omega_from_ *= lowest_seen;
  omega_to_ *= highest_seen;
}

double GrindingLobes::wheel_weight(double part_turn_s) const {
  const GrindingContact& contact = process_.grinding;
  const double part_speed = contact.part_radius_mm / part_turn_s;
  const double wheel_speed = contact.wheel_radius_mm * contact.wheel_rev_per_min / 60.0;
  return part_speed / (contact.grinding_ratio * wheel_speed);
}

std::complex<double> GrindingLobes::width_at(double omega, double part_turn_s) const {
  const GrindingContact& contact = process_.grinding;
  const double part_speed = turn_rad * contact.part_radius_mm / part_turn_s;
  const double wheel_turn_s = 60.0 / contact.wheel_rev_per_min;
  const double wheel_speed = turn_rad * contact.wheel_radius_mm / wheel_turn_s;
  std::complex<double> layers =
      met_again(omega, part_turn_s, evened_out(omega, contact.length_mm, part_speed));
  if (contact.grinding_ratio > 0.0) {
    layers += wheel_weight(part_turn_s) *
              met_again(omega, wheel_turn_s, evened_out(omega, contact.length_mm, wheel_speed));
  }
  std::complex<double> all = layers / process_.force_n_per_mm2;
  if (contact.stiffness_n_per_mm2 > 0.0) all += 1.0 / contact.stiffness_n_per_mm2;
  return -all / receptance(process_.modes_x, omega);
}

// Evenly, and close together about the orders of the wheel: its waves are met again with little
// weight, so that what they do lies within a small part of a wave.
std::vector<double> GrindingLobes::frequencies(double part_turn_s) const {
  const GrindingContact& contact = process_.grinding;
  const double wheel_turn_s = 60.0 / contact.wheel_rev_per_min;
  const double step = std::min(
      omega_step_max_, turn_rad / grinding_steps_per_wave / std::max(part_turn_s, wheel_turn_s));
  std::vector<double> all;
  for (int n = 0; omega_from_ + n * step < omega_to_; ++n) all.push_back(omega_from_ + n * step);
  if (contact.grinding_ratio <= 0.0) return all;
  const double weight = wheel_weight(part_turn_s);
  constexpr double nearest = 1e-2;  // of the weight
  constexpr double nearer = 0.7;
  const double order = turn_rad / wheel_turn_s;
  for (int n = static_cast<int>(std::ceil(omega_from_ / order)); n * order < omega_to_; ++n) {
    double away = 1.0 / wheel_turn_s;
    while (away > nearest * weight / wheel_turn_s) {
      all.push_back(n * order - away);
      all.push_back(n * order + away);
      away *= nearer;
    }
  }
  std::ranges::sort(all);
  return all;
}

std::optional<LobePoint> GrindingLobes::limit_at(double speed_rev_per_min) const {
  const double turn_s = 60.0 / speed_rev_per_min;
  std::optional<LobePoint> least;
  // A sign of the imaginary part changes at a root, and at a pole, where the width grows beyond
  // all bounds.
  const auto take = [&](double from, std::complex<double> width_from, double to) {
    constexpr int halvings = 24;
    constexpr double real_part = 1e-3;
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (from + to);
      const std::complex<double> width = width_at(middle, turn_s);
      if ((width.imag() < 0.0) == (width_from.imag() < 0.0)) {
        from = middle;
        width_from = width;
      } else {
        to = middle;
      }
    }
    const bool is_root =
        width_from.real() > 0.0 && std::abs(width_from.imag()) < real_part * width_from.real();
    if (!is_root || (least && least->depth_mm <= width_from.real())) return;
    least = {.speed_rev_per_min = speed_rev_per_min,
             .depth_mm = width_from.real(),
             .chatter_hz = from / turn_rad,
             .waves = static_cast<int>(from * turn_s / turn_rad)};
  };
  double omega_before = omega_from_;
  std::complex<double> before = width_at(omega_from_, turn_s);
  for (const double omega : frequencies(turn_s)) {
    const std::complex<double> width = width_at(omega, turn_s);
    if ((width.imag() < 0.0) != (before.imag() < 0.0)) take(omega_before, before, omega);
    before = width;
    omega_before = omega;
  }
  return least;
}

}  // namespace stanok::process
