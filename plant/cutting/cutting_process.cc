#include "plant/cutting/cutting_process.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::plant {
namespace {

// Samples of a revolution: 8 s at a cycle of 1 ms, which is a speed of 7.5 rev/min.
constexpr std::size_t samples_max = 8192;

// The static deflection follows the force over this time.
constexpr double deflection_s = 0.5;
constexpr int steps_per_sample = 4;

}  // namespace

ChipThickness::ChipThickness() : samples_(samples_max) {}

void ChipThickness::advance(double travel_mm, double turns) RT_SAFE {
  const Sample& last = samples_[newest_];
  const Sample next{.turns = last.turns + turns, .travel_mm = last.travel_mm + travel_mm};
  newest_ = (newest_ + 1) % samples_.size();
  samples_[newest_] = next;
  if (oldest_ == newest_) oldest_ = (oldest_ + 1) % samples_.size();
  const double since = next.turns - 1.0;
  for (;;) {
    const std::size_t behind = (oldest_ + 1) % samples_.size();
    if (oldest_ == newest_ || behind == newest_ || samples_[behind].turns > since) break;
    oldest_ = behind;
  }
  const Sample& a = samples_[oldest_];
  const Sample& b = samples_[(oldest_ + 1) % samples_.size()];
  const double part =
      b.turns > a.turns ? std::clamp((since - a.turns) / (b.turns - a.turns), 0.0, 1.0) : 0.0;
  thickness_mm_ = next.travel_mm - (a.travel_mm + part * (b.travel_mm - a.travel_mm));
}

CuttingProcess::CuttingProcess(const config::CuttingConfig& config)
    : config_(config),
      stock_(config.stock),
      oscillation_({.amplitude_um = config.vibration_um,
                    .frequency_hz = config.vibration_hz,
                    .mass_kg = config.vibration_mass_kg}) {}

void CuttingProcess::advance(const ToolPoint& tool, double rev_per_min, double dt_s) RT_SAFE {
  constexpr double s_per_min = 60.0;
  constexpr double m_per_mm = 1e-3;
  const double way = is_placed_ ? std::hypot(tool.x_mm - tool_.x_mm, tool.z_mm - tool_.z_mm) : 0.0;
  tool_ = tool;
  is_placed_ = true;
  const double depth_before = cut_.depth_mm;
  cut_ = stock_.move_tool(tool.x_mm, tool.z_mm);
  // A tool that rests in the cut goes on to cut until the chip has run out.
  if (way == 0.0) cut_.depth_mm = depth_before;
  const double turns_per_s = std::abs(rev_per_min) / s_per_min;
  chip_.advance(cut_.depth_mm > 0.0 ? way : 0.0, turns_per_s * dt_s);
  const double h = std::max(chip_.thickness_mm(), 0.0);
  force_n_ = turns_per_s > 0.0 && cut_.depth_mm > 0.0
                 ? config_.specific_force_n * cut_.depth_mm * std::pow(h, config_.feed_exponent) *
                       std::pow(cut_.hardness_hb / config_.hardness_hb, config_.hardness_exponent)
                 : 0.0;
  const double omega = 2.0 * std::numbers::pi * turns_per_s;
  power_w_ = force_n_ * omega * std::abs(tool.x_mm) * m_per_mm / config_.efficiency;

  force_mean_n_ += (force_n_ - force_mean_n_) * std::min(dt_s / deflection_s, 1.0);
  const double step_s = dt_s / (vibration_samples * steps_per_sample);
  const Engagement engagement = force_n_ > 0.0 ? Engagement::in_cut : Engagement::out_of_cut;
  for (double& sample : vibration_um_) {
    for (int k = 0; k < steps_per_sample; ++k)
      oscillation_.advance(force_n_ - force_mean_n_, engagement, step_s);
    sample = oscillation_.displacement_um();
  }
}

}  // namespace stanok::plant
