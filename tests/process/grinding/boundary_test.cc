// Force law, boundary and least time against the formulas of the paper and numerical integration.
#include "process/grinding/boundary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "process/grinding/baselines.h"
#include "process/grinding/force_law.h"
#include "process/grinding/stability.h"
#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

// Equation (8): Q_max = (C delta / (C_p B V^alpha))^(1/alpha), C delta in N, V in m/min.
double equation_8() {
  const double V = 2.0 * std::numbers::pi * 30.0 * 120.0 / 1000.0;
  return std::pow(25e6 * 0.010e-3 / (3.6 * 20.0 * std::pow(V, 0.56)), 1.0 / 0.56);
}

TEST(Sheet, OfThePaperHasItsDampingRatioAndRevolution) {
  EXPECT_NEAR(damping_ratio(petrakov::sheet()), 0.9000, 5e-5);
  EXPECT_DOUBLE_EQ(revolution_s(petrakov::sheet()), 0.5);
}

TEST(Boundary, ReachesTheRemovalOfEquation8) {
  EXPECT_NEAR(Boundary(petrakov::sheet()).removal_max(), equation_8(), 1e-6);
}

TEST(Boundary, IsTheLesserOfTheGreatestRemovalAndTheBurnLine) {
  const Boundary boundary(petrakov::sheet());
  const double Q_max = equation_8();
  struct Case {
    double allowance_mm, expected;
  };
  for (const Case& c : {Case{0.3, Q_max}, Case{0.09, Q_max}, Case{0.045, 0.5 * (0.05 + Q_max)},
                        Case{0.0, 0.05}, Case{-0.002, 0.05}}) {
    EXPECT_NEAR(boundary.at(c.allowance_mm), c.expected, 1e-12) << c.allowance_mm;
  }
  EXPECT_NEAR(boundary.burn_line(0.18), 0.05 + 2.0 * (Q_max - 0.05), 1e-12);
}

GrindingProcess with_curve() {
  GrindingProcess process = petrakov::sheet();
  process.burn_curve = {{0.02, 0.12}, {0.05, 0.30}};
  return process;
}

TEST(Boundary, FollowsACurveOfBurn) {
  const GrindingProcess process = with_curve();
  const Boundary boundary(process);
  const double Q_max = equation_8();
  struct Case {
    double allowance_mm, expected;
  };
  for (const Case& c :
       {Case{-0.001, 0.05}, Case{0.0, 0.05}, Case{0.01, 0.085}, Case{0.02, 0.12}, Case{0.035, 0.21},
        Case{0.05, 0.30}, Case{0.07, 0.5 * (0.30 + Q_max)}, Case{0.09, Q_max}, Case{0.2, Q_max}}) {
    EXPECT_NEAR(boundary.at(c.allowance_mm), c.expected, 1e-12) << c.allowance_mm;
  }
  EXPECT_NEAR(boundary.burn_line(0.13), Q_max + (Q_max - 0.30), 1e-12) << "as before its end";
  for (const double allowance_mm : {0.3, 0.06, 0.015}) {
    constexpr int slices = 300000;
    double revolutions = 0.0;
    for (int k = 0; k < slices; ++k) {
      const double H = allowance_mm * (k + 0.5) / slices;
      revolutions += allowance_mm / slices * (30.0 * 200.0 / 230.0) / boundary.at(H);
    }
    EXPECT_NEAR(least_time_s(process, allowance_mm), 0.5 * revolutions, 1e-5) << allowance_mm;
  }
}

TEST(Boundary, SaysWhatIsWrongWithACurveOfBurn) {
  const auto fault = [](const std::vector<BurnPoint>& curve) {
    GrindingProcess process = petrakov::sheet();
    process.burn_curve = curve;
    const auto faults = boundary_faults(process, 0.3);
    return faults.empty() ? std::string()
                          : std::string(faults.front().key) + ": " + faults.front().text;
  };
  EXPECT_EQ(fault({{0.02, 0.12}, {0.05, 0.30}}), "");
  EXPECT_NE(fault({{0.05, 0.12}, {0.02, 0.30}}).find("above the one before"), std::string::npos);
  EXPECT_NE(fault({{0.02, 0.04}}).find("permits less"), std::string::npos);
  EXPECT_NE(fault({{0.02, 0.12}, {0.09, 0.30}}).find("critical_allowance"), std::string::npos);
  EXPECT_NE(fault({{0.02, 2.0}}).find("more than Q_max"), std::string::npos);
}

TEST(ForceLaw, IsItsOwnInverse) {
  const ForceLaw law(petrakov::sheet());
  for (const double removal : {1e-4, 0.05, 0.4, 3.0}) {
    EXPECT_NEAR(law.removal_mm2_per_rad(law.force_n(removal)), removal, 1e-12 * removal);
  }
}

TEST(ForceLaw, TellsTheStiffnessOfTheCutAsTheSlopeOverTheLayer) {
  const ForceLaw law(petrakov::sheet());
  const double radius = 30.0 * 200.0 / 230.0;
  const double a = 0.005;
  const double slope = (law.force_n(radius * (a + 1e-8)) - law.force_n(radius * (a - 1e-8))) / 2e-8;
  EXPECT_NEAR(law.cutting_stiffness_n_per_mm(a), slope, 1e-4 * slope);
}

TEST(LeastTime, IsTheIntegralOfTheAllowanceOverTheBoundary) {
  const Boundary boundary(petrakov::sheet());
  constexpr int slices = 300000;
  double revolutions = 0.0;
  for (int k = 0; k < slices; ++k) {
    const double H = 0.3 * (k + 0.5) / slices;
    revolutions += 0.3 / slices * (30.0 * 200.0 / 230.0) / boundary.at(H);
  }
  EXPECT_NEAR(least_time_s(petrakov::sheet(), 0.3), 0.5 * revolutions, 1e-6);
}

TEST(Baselines, AConstantSafeFeedTakesTheTimeOfItsSimulation) {
  const GrindingProcess process = petrakov::sheet();
  const double feed = 0.05 / (30.0 * 200.0 / 230.0 * 0.5);
  const PlungeRun run = simulate_plunge(process, constant_law(0.3, -0.05, feed),
                                        {.at_end = InfeedTravel::AtEnd::goes_on});
  EXPECT_NEAR(constant_safe_time_s(process, 0.3), run.time_s, 0.002);
}

TEST(Baselines, ThreeStepsAreLimitedByTheirLastOne) {
  // All three feeds follow from the last, which Q_end permits at most: way over feed, and the
  // overrun.
  const double feed = 0.05 / (30.0 * 200.0 / 230.0 * 0.5);
  const double least_s = 0.3 * (0.70 / 4.0 + 0.18 / 2.0 + 0.12) / feed;
  const double time_s = three_step_time_s(petrakov::sheet(), 0.3, {});
  EXPECT_GT(time_s, least_s);
  EXPECT_LT(time_s, 1.1 * least_s);
}

// k_lim = -1 / (2 min Re G) of the oscillator G = 1 / (C - m w^2 + i b w), found on a fine grid.
TEST(Stability, MarginIsThatOfTheNegativeRealPartOfTheSystem) {
  const GrindingProcess process = petrakov::sheet();
  double real_min = 0.0;
  for (double w = 1.0; w < 20000.0; w += 0.5) {
    const double real = 25000.0 - 0.032 * w * w;
    const double imaginary = 50.9117 * w;
    real_min = std::min(real_min, real / (real * real + imaginary * imaginary));
  }
  const double layer_mm = 0.05 / (30.0 * 200.0 / 230.0);
  const double cut = ForceLaw(process).cutting_stiffness_n_per_mm(layer_mm);
  EXPECT_NEAR(stability_margin(process), -1.0 / (2.0 * real_min) / cut, 1e-4);
}

}  // namespace
}  // namespace stanok::process
