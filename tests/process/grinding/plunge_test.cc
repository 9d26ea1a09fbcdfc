// The simulation of a plunge against balances, closed forms and an integration of its own.
#include "process/grinding/plunge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

using std::numbers::pi;

double removal_at(const PlungeRun& run, double time_s) {
  const auto sample =
      std::lower_bound(run.samples.begin(), run.samples.end(), time_s,
                       [](const PlungeSample& s, double t) { return s.time_s < t - 1e-9; });
  return sample->removal_mm2_per_rad;
}

TEST(Plunge, RemovesTheAreaOfTheLayerThatIsGoneInTheExactForm) {
  GrindingProcess process = petrakov::sheet();
  process.removal = RemovalForm::exact;
  const PlungeRun run = simulate_plunge(process, petrakov::table(), {});
  const double layer_mm = 0.3 - run.residual_mean_mm;
  EXPECT_NEAR(run.volume_mm2 / (2.0 * pi * 30.0 * layer_mm), 1.0, 1e-9);  // asked for: 1e-3
}

TEST(Plunge, KeepsTheBalanceOfMassForRandomCycles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> of_one(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    GrindingProcess process = petrakov::sheet();
    process.removal = RemovalForm::exact;
    process.stiffness_n_per_m = std::pow(10.0, 7.0 + of_one(random));
    process.part_speed_rpm = 40.0 + 200.0 * of_one(random);
    const InfeedLaw law{{0.2, 0.01 + 0.03 * of_one(random)}, {0.0, 0.004 + 0.01 * of_one(random)}};
    const PlungeRun run = simulate_plunge(process, law, {.spark_out_revolutions = 2.0});
    EXPECT_NEAR(run.volume_mm2 / (2.0 * pi * 30.0 * (0.2 - run.residual_mean_mm)), 1.0, 1e-9)
        << "seed 7, trial " << trial;
  }
}

// In steady state a revolution takes one layer V tau, and the spring holds its force.
TEST(Plunge, SettlesToOneLayerPerRevolutionAndTheDeflectionOfItsForce) {
  const double feed = 0.02;
  const PlungeRun run = simulate_plunge(petrakov::sheet(), constant_law(0.3, 0.0, feed), {});
  const double removal = 30.0 * 200.0 / 230.0 * feed * 0.5;
  const double surface_speed = 2.0 * pi * 0.030 * 120.0;
  const double force = 3.6 * 20.0 * std::pow(removal * surface_speed, 0.56);
  EXPECT_NEAR(run.samples.back().removal_mm2_per_rad, removal, 1e-6 * removal);
  EXPECT_NEAR(run.samples.back().deflection_mm, force / 25000.0, 1e-6 * force / 25000.0);
}

// The same equations with explicit steps a hundred times shorter (semi-implicit Euler).
TEST(Plunge, AgreesWithAnIntegrationInMuchShorterSteps) {
  constexpr double feed = 0.04;
  constexpr double h = 5e-6;
  constexpr int per_revolution = 100000;
  std::vector<double> surface(per_revolution, 0.0);
  double y = 0.0;
  double dy = 0.0;
  const PlungeRun run = simulate_plunge(petrakov::sheet(), constant_law(0.3, 0.2, feed), {});
  for (int step = 1; step <= 4 * per_revolution; ++step) {
    double& before = surface[static_cast<std::size_t>(step % per_revolution)];
    const double depth = feed * step * h - y;
    const double layer = std::max(0.0, depth - before);
    const double removal = 30.0 * 200.0 / 230.0 * layer;
    const double force = 72.0 * std::pow(removal * 2.0 * pi * 3.6, 0.56);
    dy += h * (force - 50.9117 * dy - 25000.0 * y) / 0.032;
    y += h * dy;
    before = std::max(before, depth);
    if (step % 20000 == 0) {
      EXPECT_NEAR(removal_at(run, step * h), removal, 2e-3 * removal + 1e-5) << step * h << " s";
    }
  }
}

TEST(Plunge, ChangesByLessThanTwoPerMilleWhenTheStepIsHalved) {
  const PlungeRun coarse = simulate_plunge(petrakov::sheet(), petrakov::table(), {});
  const PlungeRun fine =
      simulate_plunge(petrakov::sheet(), petrakov::table(), {.time_step_max_s = 0.00025});
  EXPECT_NEAR(coarse.time_s / fine.time_s, 1.0, 2e-3);
  EXPECT_NEAR(coarse.force_max_n / fine.force_max_n, 1.0, 2e-3);
  EXPECT_NEAR(coarse.volume_mm2 / fine.volume_mm2, 1.0, 2e-3);
  for (double time_s = 0.05; time_s < 18.0; time_s += 0.25) {
    const double removal = removal_at(fine, time_s);
    EXPECT_NEAR(removal_at(coarse, time_s), removal, 2e-3 * removal) << time_s << " s";
  }
}

TEST(Plunge, TakesNothingBeforeTheTouchAndNeverANegativeLayer) {
  const PlungeRun run = simulate_plunge(petrakov::sheet(), petrakov::table(), {});
  for (const PlungeSample& sample : run.samples) ASSERT_GE(sample.removal_mm2_per_rad, 0.0);
  EXPECT_LT(run.samples.front().removal_mm2_per_rad, 1e-3);
}

// Standing still, the wheel takes with every turn what the spring gives back:
// C y_n = c (y_{n-1} - y_n)^alpha, without inertia and friction (b/C is 2 ms, a turn 500 ms).
double relaxed_deflection_mm(double y, int revolutions) {
  const double c = 72.0 * std::pow(30.0 * 200.0 / 230.0 * 2.0 * pi * 3.6, 0.56);
  for (int n = 0; n < revolutions; ++n) {
    double low = 0.0;
    double high = y;
    for (int k = 0; k < 100; ++k) {
      const double middle = 0.5 * (low + high);
      (25000.0 * middle < c * std::pow(y - middle, 0.56) ? low : high) = middle;
    }
    y = low;
  }
  return y;
}

TEST(Plunge, SparksOutAsTheSpringRelaxesTurnByTurn) {
  const InfeedLaw law = constant_law(0.1, 0.0, 0.02);
  const double fed_mm = simulate_plunge(petrakov::sheet(), law, {}).samples.back().deflection_mm;
  for (const int revolutions : {1, 2, 5, 20}) {
    const PlungeRun run = simulate_plunge(
        petrakov::sheet(), law, {.spark_out_revolutions = static_cast<double>(revolutions)});
    const double expected_mm = relaxed_deflection_mm(fed_mm, revolutions);
    EXPECT_NEAR(run.time_s, 5.0 + 0.5 * revolutions, 1e-3);
    EXPECT_NEAR(run.samples.back().deflection_mm, expected_mm, 0.02 * expected_mm) << revolutions;
    EXPECT_NEAR(run.samples.back().allowance_mm, expected_mm, 0.02 * expected_mm) << revolutions;
  }
}

// dw/dt = f(Q): with a constant rate the wheel loses rate x time, and the part stays that much
// larger.
TEST(Plunge, WearOfTheWheelLeavesThePartLarger) {
  const PlungeOptions worn{.wear_rate_mm_per_s = [](double removal) { return 1e-4 * removal; }};
  const InfeedLaw law = constant_law(0.2, 0.0, 0.01);
  const PlungeRun sharp = simulate_plunge(petrakov::sheet(), law, {});
  const PlungeRun run = simulate_plunge(petrakov::sheet(), law, worn);
  double expected_mm = 0.0;
  for (const PlungeSample& sample : run.samples) {
    expected_mm += 1e-4 * sample.removal_mm2_per_rad * 0.0005;
  }
  EXPECT_NEAR(run.wear_mm, expected_mm, 1e-9);
  EXPECT_NEAR(run.residual_mm - sharp.residual_mm, run.wear_mm, 0.05 * run.wear_mm);
}

TEST(Plunge, GivesUpWhenTheTimeIsOver) {
  PlungeOptions options{.at_end = InfeedTravel::AtEnd::goes_on, .time_max_s = 2.0};
  const PlungeRun run = simulate_plunge(petrakov::sheet(), constant_law(0.3, 0.0, 0.001), options);
  EXPECT_FALSE(run.size_reached_s.has_value());
  EXPECT_NEAR(run.time_s, 2.0, 1e-3);
}

}  // namespace
}  // namespace stanok::process
