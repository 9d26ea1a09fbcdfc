// Twenty lathes with hidden figures, cut angle by angle here; what the fit says of them.
#include "process/identify/turning_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/support/sanitized.h"

namespace stanok::process {
namespace {

struct HiddenLathe {
  double coefficient_n = 0.0;  // C / eta
  double exponent = 0.0;
  double lag_s = 0.0;
  double idle_linear = 0.0;
  double idle_square = 0.0;
  double noise = 0.0;
};

HiddenLathe hidden(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  return {.coefficient_n = between(900.0, 3000.0),
          .exponent = between(0.6, 0.9),
          .lag_s = between(0.015, 0.06),
          .idle_linear = between(0.1, 0.4),
          .idle_square = between(5e-5, 3e-4),
          .noise = between(0.04, 0.09)};
}

// A bar of three depths, cut at two speeds with feeds that change every few turns. The surface is
// kept for each of 360 angles; the lag is solved in steps of a twentieth of a millisecond.
// One integrator, read beside its equations.
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
CutRecord recorded(const HiddenLathe& lathe, std::mt19937& random) {
  constexpr int angles = 360;
  constexpr int steps = 20;
  std::normal_distribution<double> gauss(0.0, 1.0);
  CutRecord record;
  double power_w = 0.0;
  int cycle = 0;
  for (const double rev_per_min : {500.0, 900.0}) {
    std::vector<double> cut_at(angles, 0.0);
    double z = -2.0;
    double angle = 0.0;
    double force = 0.0;
    for (double t = 0.0; z < 45.0; t += 0.001, ++cycle) {
      const double feeds[] = {0.12, 0.3, 0.2, 0.4};
      const double feed = t < 0.7 ? 0.0 : feeds[static_cast<int>(t / 1.5) % 4] * rev_per_min / 60.0;
      const double radius = 30.0;
      for (int k = 0; k < steps; ++k) {
        const double dt = 0.001 / steps;
        z += feed * dt;
        const int from = static_cast<int>(angle * angles);
        angle += rev_per_min / 60.0 * dt;
        for (int a = from; a < static_cast<int>(angle * angles); ++a) {
          double& at = cut_at[static_cast<std::size_t>(a % angles)];
          const double h = std::max(0.0, z - std::max(at, 0.0));
          at = z;
          const double now = z <= 0.0 ? 0.0 : z < 15.0 ? 1.5 : z < 30.0 ? 3.0 : 2.0;
          force = lathe.coefficient_n * now * std::pow(h, lathe.exponent);
        }
        if (angle >= 1.0) angle -= 1.0;
        const double wanted = force * 2.0 * std::numbers::pi * rev_per_min / 60.0 * radius * 1e-3;
        power_w += (wanted - power_w) * (1.0 - std::exp(-dt / lathe.lag_s));
      }
      CutRow row{.rev_per_min = rev_per_min,
                 .radius_mm = radius,
                 .depth_mm = z <= 0.0   ? 0.0
                             : z < 15.0 ? 1.5
                             : z < 30.0 ? 3.0
                                        : 2.0,
                 .travel_mm = feed * 0.001};
      if (cycle % 10 == 9) {
        const double idle =
            lathe.idle_linear * rev_per_min + lathe.idle_square * rev_per_min * rev_per_min;
        row.power_w = std::round(idle + power_w * (1.0 + lathe.noise * gauss(random)));
      }
      record.rows.push_back(row);
    }
  }
  return record;
}

// 95 % intervals: of a hundred values at least ninety lie inside.
TEST(TurningFit, ItsIntervalsHoldTheHiddenValues) {
  std::mt19937 random(20264);
  int inside = 0;
  int all = 0;
  double worst_exponent = 0.0;
  for (int plant = 0; plant < stanok::testing::cases(20); ++plant) {
    const HiddenLathe lathe = hidden(random);
    const auto fit = fit_turning(recorded(lathe, random));
    ASSERT_TRUE(fit.has_value()) << fit.error();
    const bool hits[] = {fit->coefficient_n.contains(lathe.coefficient_n),
                         fit->exponent.contains(lathe.exponent), fit->lag_s.contains(lathe.lag_s),
                         fit->idle_linear.contains(lathe.idle_linear),
                         fit->idle_square->contains(lathe.idle_square)};
    for (const bool hit : hits) {
      inside += hit ? 1 : 0;
      ++all;
    }
    EXPECT_NEAR(fit->coefficient_n.value, lathe.coefficient_n, 0.05 * lathe.coefficient_n);
    EXPECT_NEAR(fit->idle_w(700.0), lathe.idle_linear * 700.0 + lathe.idle_square * 490000.0, 1.0);
    EXPECT_NEAR(fit->noise, lathe.noise, 0.2 * lathe.noise);
    worst_exponent = std::max(worst_exponent, std::abs(fit->exponent.value - lathe.exponent));
  }
  RecordProperty("inside", std::to_string(inside));
  RecordProperty("exponent_worst", std::to_string(worst_exponent));
  EXPECT_GE(inside, all * 9 / 10);
}

TEST(TurningFit, SaysWhatTheRecordLacks) {
  std::mt19937 random(1);
  HiddenLathe lathe = hidden(random);
  CutRecord record = recorded(lathe, random);
  for (CutRow& row : record.rows) row.depth_mm = 0.0;
  EXPECT_NE(fit_turning(record).error().find("in the cut"), std::string::npos);
  record = recorded(lathe, random);
  std::erase_if(record.rows, [](const CutRow& row) { return row.depth_mm == 0.0; });
  EXPECT_NE(fit_turning(record).error().find("idling"), std::string::npos);
  record = recorded(lathe, random);
  for (CutRow& row : record.rows) row.travel_mm = row.travel_mm > 0.0 ? 0.002 : 0.0;
  std::erase_if(record.rows, [](const CutRow& row) { return row.rev_per_min > 600.0; });
  const auto one_feed = fit_turning(record);
  EXPECT_FALSE(one_feed.has_value());
}

}  // namespace
}  // namespace stanok::process
