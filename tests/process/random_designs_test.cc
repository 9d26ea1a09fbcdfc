// Two hundred designs of random sheets, run again by an integrator of the test's own with another
// scheme and step: time, quality, size and growth as stated, or a refusal with its reason.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "process/grinding/cycle_design.h"
#include "process/grinding/stability.h"
#include "tests/process/petrakov.h"
#include "tests/process/plunge_oracle.h"

namespace stanok::process {
namespace {

class RandomDesign : public ::testing::TestWithParam<unsigned> {};

DesignRequest random_request(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  DesignRequest request;
  request.process = petrakov::sheet();
  request.allowance_mm = between(0.1, 0.4);
  GrindingProcess& p = request.process;
  p.part_radius_mm = between(10.0, 60.0);
  p.width_mm = between(8.0, 40.0);
  p.wheel_radius_mm = between(120.0, 300.0);
  p.stiffness_n_per_m = between(12e6, 50e6);
  p.mass_kg = between(15.0, 60.0);
  p.damping_n_s_per_m = 2.0 * between(0.2, 1.0) * std::sqrt(p.stiffness_n_per_m * p.mass_kg);
  p.part_speed_rpm = between(60.0, 240.0);
  p.force_factor = between(2.0, 6.0);
  p.force_exponent = between(0.5, 0.75);
  p.deflection_max_mm = between(0.006, 0.015);
  p.critical_allowance_mm = between(0.25, 0.6) * request.allowance_mm;
  const double V = 2.0 * 3.14159265358979 * p.part_radius_mm * p.part_speed_rpm / 1000.0;
  const double Q_max =
      std::pow(p.stiffness_n_per_m / 1000.0 * p.deflection_max_mm / (p.force_factor * p.width_mm),
               1.0 / p.force_exponent) /
      V;
  p.removal_end_mm2_per_rad = between(0.1, 0.3) * Q_max;
  if (seed % 4 == 1) {
    const double rise = Q_max - p.removal_end_mm2_per_rad;
    const double first = between(0.05, 0.9);
    p.burn_curve = {{0.3 * p.critical_allowance_mm, p.removal_end_mm2_per_rad + 0.5 * first * rise},
                    {0.7 * p.critical_allowance_mm, p.removal_end_mm2_per_rad + first * rise}};
  }
  request.staircase.points = static_cast<int>(between(1.0, 6.0));
  request.staircase.effort = StaircaseEffort::quick;
  request.comparison = Comparison::none;
  if (seed % 3 == 0) {
    request.limits.roundness_max_mm = between(0.0002, 0.001);
    request.spark_out = SparkOut::found;
  }
  return request;
}

TEST_P(RandomDesign, IsWhatItSays) {
  const DesignRequest request = random_request(GetParam());
  const auto design = design_cycle(request);
  if (!design) {
    ASSERT_TRUE(has_errors(design.error()));
    for (const Finding& finding : design.error()) EXPECT_GT(finding.text.size(), 20U);
    return;
  }
  const Verification& stated = design->verification;
  if (stability_margin(request.process) < 1.0) {
    // Its waves grow from rounding, differently with every step: it is refused.
    EXPECT_TRUE(has_errors(stated.findings));
    return;
  }
  // Four times this changes no ratio by more than 2e-5.
  constexpr int steps_per_turn = 20'000;
  const testing::OraclePlunge run = testing::run_plunge(
      request.process, design->law, design->spark_out_revolutions, steps_per_turn);
  EXPECT_NEAR(run.time_s, stated.run.time_s, 0.001);
  EXPECT_NEAR(run.burn_ratio, stated.burn.ratio, 1e-4 * stated.burn.ratio);
  // A step of 0.5 ms is up to 2e-5 mm of feed; both sides have one.
  EXPECT_NEAR(run.highest_mm, stated.run.residual_mm, 4e-5);
  EXPECT_NEAR(run.highest_mm - run.lowest_mm, stated.run.out_of_roundness_mm(), 5e-5);
  if (!has_errors(stated.findings)) {
    EXPECT_LE(run.highest_mm, request.limits.residual_max_mm + 4e-5);
    EXPECT_GE(run.highest_mm, -request.limits.undersize_max_mm - 4e-5);
    EXPECT_LE(run.burn_ratio, 1.0 + request.limits.burn_margin + 1e-4);
    if (request.limits.roundness_max_mm > 0.0) {
      EXPECT_LE(run.highest_mm - run.lowest_mm, request.limits.roundness_max_mm + 5e-5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomDesign, ::testing::Range(1U, 21U));
INSTANTIATE_TEST_SUITE_P(FullSize, RandomDesign, ::testing::Range(21U, 201U));

// The linear cut m y'' + b y' + C y = -k (y - y(t - tau)) from noise on, by the leap-frog scheme
// with the damping in the middle: what the waves grow by in a revolution, as the mean over many
// late ones. Waves that grow nearly alike beat in each single one.
double growth_of_waves(const GrindingProcess& process, double k_n_per_m) {
  const double turn_s = 60.0 / process.part_speed_rpm;
  const int steps = 20000;
  const double dt = turn_s / steps;
  std::vector<double> before(steps);
  std::vector<double> now(steps);
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(0.0, 1.0);
  for (double& value : before) value = gauss(random);
  double y = 0.0;
  double y_old = 0.0;
  constexpr int turns = 200;
  constexpr int late = 100;
  double growth_log = 0.0;
  for (int turn = 0; turn < turns; ++turn) {
    double power = 0.0;
    for (int n = 0; n < steps; ++n) {
      const double force = -k_n_per_m * (y - before[static_cast<std::size_t>(n)]);
      const double half = 0.5 * process.damping_n_s_per_m / dt;
      const double mass = process.mass_kg / (dt * dt);
      const double next =
          (force - process.stiffness_n_per_m * y + 2.0 * mass * y - (mass - half) * y_old) /
          (mass + half);
      y_old = y;
      y = next;
      now[static_cast<std::size_t>(n)] = y;
      power += y * y;
    }
    // The next one begins with waves of size 1.
    const double size = std::sqrt(power / steps);
    if (turn >= late) growth_log += std::log(size) / (turns - late);
    for (double& value : now) value /= size;
    y /= size;
    y_old /= size;
    std::swap(before, now);
  }
  return std::exp(growth_log);
}

// Cuts from unstable to stable ones; in the late turns the wave that grows most is left.
TEST(WaveGrowth, IsThatOfTheDelayedSystem) {
  int growing = 0;
  for (unsigned seed = 1; seed <= 24; ++seed) {
    GrindingProcess p = random_request(seed).process;
    const double zeta = 0.03 * std::pow(30.0, seed / 24.0);
    p.damping_n_s_per_m = 2.0 * zeta * std::sqrt(p.stiffness_n_per_m * p.mass_kg);
    const double R = p.part_radius_mm * p.wheel_radius_mm / (p.part_radius_mm + p.wheel_radius_mm);
    const double layer_mm = p.removal_end_mm2_per_rad / R;
    const double V = 2.0 * 3.14159265358979 * p.part_radius_mm * p.part_speed_rpm / 1000.0;
    const double force =
        p.force_factor * p.width_mm * std::pow(p.removal_end_mm2_per_rad * V, p.force_exponent);
    const double k = p.force_exponent * force / layer_mm * 1000.0;  // N/m
    const double growth = wave_growth(p);
    EXPECT_NEAR(growth_of_waves(p, k), growth, 0.01 * growth) << seed;
    EXPECT_EQ(growth > 1.0, stability_margin(p) < 1.0) << seed;
    if (growth > 1.0) ++growing;
  }
  EXPECT_GT(growing, 5);
  EXPECT_LT(growing, 19);
}

}  // namespace
}  // namespace stanok::process
