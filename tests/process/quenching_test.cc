// A van der Pol plant in the loop: its self-oscillation dies out under the oscillation of the force
// that the control forms from it, and the more of it is missing the less.
#include <gtest/gtest.h>

#include <cmath>

#include "drives/vibration_meter.h"
#include "plant/cutting/self_oscillation.h"
#include "tests/process/cut_bench.h"

namespace stanok::process {
namespace {

using testing::CutBench;
using testing::force_command;

constexpr double self_um = 12.0;
constexpr double self_hz = 113.0;  // no order of the spindle, which has 10 Hz
constexpr double mass_kg = 2.0;
constexpr double swing_hz = 4.0;

class Quenching {
 public:
  // `reserve`: P over P_q.
  explicit Quenching(double reserve)
      : bench_({.efficiency = 0.85,
                .power_lag_s = 0.025,
                .vibration_level_um = 6.0,
                .reduced_mass_kg = mass_kg,
                .oscillation_hz = swing_hz,
                .oscillation_reserve = reserve}) {}

  // Amplitude at the plant's own frequency, after the oscillation has worked for a while.
  double residual_um() {
    EXPECT_TRUE(bench_.control.command(force_command(1500.0)));
    EXPECT_TRUE(bench_.control.command({.kind = motion::ForceCommand::Kind::vibration_on}));
    bench_.wait_until_ready();
    bench_.cut_at_feed();
    bench_.depth_mm = 2.0;
    run(12.0);
    EXPECT_GT(bench_.control.status().oscillation_n, 0.0);
    return amplitude_near_self_frequency();
  }

 private:
  void run(double seconds) {
    for (int k = 0; k < static_cast<int>(seconds * 1000.0); ++k) cycle();
  }
  void cycle() {
    bench_.cycle();
    mean_n_ += (bench_.force_n - mean_n_) * 0.001 / 0.5;
    std::array<double, 4> samples{};
    for (double& sample : samples) {
      for (int k = 0; k < 4; ++k)
        plant_.advance(
            bench_.force_n - mean_n_,
            bench_.force_n > 0.0 ? plant::Engagement::in_cut : plant::Engagement::out_of_cut,
            0.001 / 16.0);
      sample = plant_.displacement_um();
    }
    meter_.add(samples, bench_.cut.rev_per_min);
    static_cast<void>(meter_.work());
    bench_.cut.vibration_um = meter_.level().amplitude_um;
    bench_.cut.vibration_hz = meter_.level().frequency_hz;
  }
  // The strongest harmonic within 3 Hz of the self-oscillation over 4 s.
  double amplitude_near_self_frequency() {
    std::vector<double> x;
    for (int k = 0; k < 4000; ++k) {
      cycle();
      x.push_back(plant_.displacement_um());
    }
    double strongest = 0.0;
    for (double hz = self_hz - 3.0; hz <= self_hz + 3.0; hz += 0.05) {
      double sine = 0.0;
      double cosine = 0.0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        const double angle = 2.0 * std::numbers::pi * hz * 1e-3 * static_cast<double>(k);
        sine += x[k] * std::sin(angle);
        cosine += x[k] * std::cos(angle);
      }
      strongest =
          std::max(strongest, 2.0 * std::hypot(sine, cosine) / static_cast<double>(x.size()));
    }
    return strongest;
  }

  CutBench bench_;
  plant::SelfOscillation plant_{
      {.amplitude_um = self_um, .frequency_hz = self_hz, .mass_kg = mass_kg}};
  drives::VibrationMeter meter_{4000.0};
  double mean_n_ = 0.0;
};

TEST(Quenching, LeavesATenthOfTheSelfOscillationAtMost) {
  for (const double reserve : {1.1, 1.3}) {
    const double residual = Quenching(reserve).residual_um();
    RecordProperty("residual_percent_at_" + std::to_string(reserve),
                   std::to_string(100.0 * residual / self_um));
    EXPECT_LE(residual, 0.1 * self_um) << reserve;
  }
}

TEST(Quenching, NeedsTheForceOfTheEquation) {
  for (const double reserve : {0.5, 0.8}) {
    const double residual = Quenching(reserve).residual_um();
    RecordProperty("residual_percent_at_" + std::to_string(reserve),
                   std::to_string(100.0 * residual / self_um));
    EXPECT_GT(residual, 0.3 * self_um) << reserve;
  }
}

}  // namespace
}  // namespace stanok::process
