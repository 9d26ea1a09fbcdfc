// Twenty grinders with hidden stiffness and force law, run by the integrator of the tests; what the
// fit says of them from the power of the wheel spindle.
#include "process/identify/grinding_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/process/petrakov.h"
#include "tests/process/plunge_oracle.h"

namespace stanok::process {
namespace {

constexpr double watts_per_newton = 14.0;  // force ratio 0.34, 35 m/s, efficiency 0.85

GrindRecord recorded_cycle(const GrindingProcess& process, double idle_w, double lag_s,
                           double noise, std::mt19937& random) {
  const InfeedLaw law{{0.3, 0.03},   {0.15, 0.03},  {0.15, 0.012},
                      {0.05, 0.012}, {0.05, 0.004}, {0.0, 0.004}};
  std::normal_distribution<double> gauss(0.0, 1.0);
  GrindRecord record{.allowance_mm = 0.3, .watts_per_newton = watts_per_newton, .rows = {}};
  double due_s = 0.001;
  double time_before_s = 0.0;
  double shown_n = 0.0;
  const auto watch = [&](double time_s, double x_mm, double force_n) {
    shown_n += (force_n - shown_n) * (1.0 - std::exp(-(time_s - time_before_s) / lag_s));
    time_before_s = time_s;
    if (time_s < due_s - 1e-9) return;
    due_s += 0.001;
    GrindRow row{.x_mm = x_mm};
    if (record.rows.size() % 10 == 9)
      row.power_w = std::round(idle_w + watts_per_newton * shown_n * (1.0 + noise * gauss(random)));
    record.rows.push_back(row);
  };
  static_cast<void>(testing::run_plunge(process, law, 6.0, 5000, watch));
  return record;
}

TEST(GrindingFit, FullSizeItsIntervalsHoldTheHiddenValues) {
  std::mt19937 random(20265);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int inside = 0;
  int all = 0;
  for (int plant = 0; plant < 20; ++plant) {
    GrindingProcess hidden = petrakov::sheet();
    hidden.stiffness_n_per_m = between(15e6, 40e6);
    hidden.force_factor = between(2.5, 5.0);
    hidden.force_exponent = between(0.5, 0.7);
    const double idle_w = std::round(between(500.0, 1500.0));
    const double lag_s = between(0.005, 0.06);
    const GrindRecord record = recorded_cycle(hidden, idle_w, lag_s, between(0.04, 0.09), random);
    const auto fit = fit_grinding(record, petrakov::sheet());
    ASSERT_TRUE(fit.has_value()) << fit.error();
    const auto count = [&](const Estimate& estimate, double truth) {
      ++all;
      inside += estimate.low <= truth && truth <= estimate.high ? 1 : 0;
    };
    count(fit->stiffness_n_per_m, hidden.stiffness_n_per_m);
    count(fit->force_factor, hidden.force_factor);
    count(fit->force_exponent, hidden.force_exponent);
    count(fit->idle_w, idle_w);
    count(fit->lag_s, lag_s);
    EXPECT_NEAR(fit->stiffness_n_per_m.value, hidden.stiffness_n_per_m,
                0.15 * hidden.stiffness_n_per_m);
  }
  RecordProperty("inside", std::to_string(inside));
  EXPECT_GE(inside, all * 9 / 10);
}

}  // namespace
}  // namespace stanok::process
