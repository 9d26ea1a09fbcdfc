#include "process/chatter/stability_lobes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stanok::process {
namespace {

using Complex = std::complex<double>;

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr int steps_per_width = 150;  // frequencies within the width of a resonance
constexpr double widths_seen = 60.0;
constexpr double farthest = 4.0;  // of the highest natural frequency

// Mean of the directional coefficients over a turn, times 2 pi / N.
struct Directional {
  double xx = 0.0;
  double xy = 0.0;
  double yx = 0.0;
  double yy = 0.0;
};

Directional directional(const CuttingProcess& process) {
  const double r = process.radial_ratio;
  const auto at = [r](double phi) {
    const double c = std::cos(2.0 * phi);
    const double s = std::sin(2.0 * phi);
    return Directional{.xx = 0.5 * (c - 2.0 * r * phi + r * s),
                       .xy = 0.5 * (-s - 2.0 * phi + r * c),
                       .yx = 0.5 * (-s + 2.0 * phi + r * c),
                       .yy = 0.5 * (-c - 2.0 * r * phi - r * s)};
  };
  const Directional entry = at(process.entry_rad);
  const Directional exit = at(process.exit_rad);
  return {.xx = exit.xx - entry.xx,
          .xy = exit.xy - entry.xy,
          .yx = exit.yx - entry.yx,
          .yy = exit.yy - entry.yy};
}

// Roots Lambda of 1 + a1 Lambda + a0 Lambda^2 = 0; the second one is 0 where there is none.
std::array<Complex, 2> eigenvalues(const Complex& a0, const Complex& a1) {
  const Complex root = std::sqrt(a1 * a1 - 4.0 * a0);
  const Complex sum = std::abs(a1 + root) > std::abs(a1 - root) ? a1 + root : a1 - root;
  return {-2.0 / sum, std::abs(a0) > 0.0 ? -sum / (2.0 * a0) : Complex{}};
}

// Frequencies close together where a mode is near.
std::vector<double> frequencies(const CuttingProcess& process) {
  std::vector<double> all;
  double highest = 0.0;
  for (const auto* modes : {&process.modes_x, &process.modes_y}) {
    for (const VibrationMode& mode : *modes) {
      const double step = mode.damping * mode.omega() / steps_per_width;
      const int count = static_cast<int>(widths_seen * steps_per_width);
      for (int k = -count; k <= count; ++k) {
        // From the resonance outwards in steps that grow.
        const double away = step * k * (1.0 + 0.001 * std::abs(k));
        if (mode.omega() + away > 0.0) all.push_back(mode.omega() + away);
      }
      highest = std::max(highest, mode.omega());
    }
  }
  std::erase_if(all, [highest](double omega) { return omega > farthest * highest; });
  std::ranges::sort(all);
  const auto doubled = std::ranges::unique(all);
  all.erase(doubled.begin(), doubled.end());
  return all;
}

}  // namespace

void engage(CuttingProcess& process, MillingSense sense, double width_per_diameter) {
  const double angle = std::acos(1.0 - 2.0 * std::clamp(width_per_diameter, 0.0, 1.0));
  process.entry_rad = sense == MillingSense::up ? 0.0 : std::numbers::pi - angle;
  process.exit_rad = sense == MillingSense::up ? angle : std::numbers::pi;
}

StabilityLobes::StabilityLobes(const CuttingProcess& process) : process_(process) {
  add_branches();
}

// For turning 1 + K b G z = 0.
StabilityLobes::Roots StabilityLobes::roots_at(double omega) const {
  const Complex gx = receptance(process_.modes_x, omega);
  if (process_.kind == CutKind::turning) return {-1.0 / (process_.force_n_per_mm2 * gx), {}};
  const Directional d = directional(process_);
  const Complex gy = receptance(process_.modes_y, omega);
  const Complex a0 = gx * gy * (d.xx * d.yy - d.xy * d.yx);
  const Complex a1 = d.xx * gx + d.yy * gy;
  const double per_eigenvalue = -2.0 * two_pi / (process_.teeth * process_.force_n_per_mm2);
  auto [first, second] = eigenvalues(a0, a1);
  return {per_eigenvalue * first, per_eigenvalue * second};
}

// Each root is followed from frequency to frequency, as nearly as it goes on.
void StabilityLobes::add_branches() {
  std::array<Branch, 2> open;
  Roots before{};
  const auto close = [&](Branch& branch) {
    if (branch.size() > 1) branches_.push_back(branch);
    branch.clear();
  };
  for (const double omega : frequencies(process_)) {
    Roots roots = roots_at(omega);
    const double straight = std::abs(roots[0] - before[0]) + std::abs(roots[1] - before[1]);
    const double crossed = std::abs(roots[1] - before[0]) + std::abs(roots[0] - before[1]);
    if (crossed < straight) std::swap(roots[0], roots[1]);
    before = roots;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const Complex z = roots[k];
      if (z.real() > 0.0) {
        open[k].push_back({.omega = omega,
                           .depth_mm = std::norm(z) / (2.0 * z.real()),
                           .part = std::atan2(z.real(), z.imag()) / std::numbers::pi});
      } else {
        close(open[k]);
      }
    }
  }
  for (Branch& branch : open) close(branch);
}

LobePoint StabilityLobes::point_of(const Border& border, int waves) const {
  const double period = two_pi * (border.part + waves) / border.omega;
  const int cuts = process_.kind == CutKind::turning ? 1 : process_.teeth;
  return {.speed_rev_per_min = 60.0 / (cuts * period),
          .depth_mm = border.depth_mm,
          .chatter_hz = border.omega / two_pi,
          .waves = waves};
}

std::optional<LobePoint> StabilityLobes::limit_at(double speed_rev_per_min) const {
  const int cuts = process_.kind == CutKind::turning ? 1 : process_.teeth;
  const double period = 60.0 / (cuts * speed_rev_per_min);
  const auto waves_of = [period](const Border& border) {
    return border.omega * period / two_pi - border.part;
  };
  std::optional<LobePoint> least;
  for (const Branch& branch : branches_) {
    for (std::size_t k = 0; k + 1 < branch.size(); ++k) {
      const double before = waves_of(branch[k]);
      const double after = waves_of(branch[k + 1]);
      const int last = static_cast<int>(std::floor(std::max(before, after)));
      for (int waves = std::max(static_cast<int>(std::ceil(std::min(before, after))), 0);
           waves <= last; ++waves) {
        const double part = before == after ? 0.0 : (waves - before) / (after - before);
        const double depth = std::lerp(branch[k].depth_mm, branch[k + 1].depth_mm, part);
        if (least && least->depth_mm <= depth) continue;
        const double omega = std::lerp(branch[k].omega, branch[k + 1].omega, part);
        least = {.speed_rev_per_min = speed_rev_per_min,
                 .depth_mm = depth,
                 .chatter_hz = omega / two_pi,
                 .waves = waves};
      }
    }
  }
  return least;
}

std::optional<LobePoint> StabilityLobes::least_limit() const {
  std::optional<LobePoint> least;
  for (const Branch& branch : branches_) {
    for (const Border& border : branch) {
      if (!least || border.depth_mm < least->depth_mm) least = point_of(border, 0);
    }
  }
  return least;
}

}  // namespace stanok::process
