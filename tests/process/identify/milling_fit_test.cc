// Twenty mills with hidden figures, cut tooth by tooth here; what the fit says of them.
#include "process/identify/milling_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace stanok::process {
namespace {

constexpr int teeth = 3;
constexpr double radius_mm = 5.0;

struct HiddenMill {
  double force_n_per_mm2 = 0.0;  // over the efficiency
  double edge_n_per_mm = 0.0;
  double lag_s = 0.0;
  double idle_linear = 0.0;
  double idle_square = 0.0;
  double noise = 0.0;
};

HiddenMill hidden_mill(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  return {.force_n_per_mm2 = between(600.0, 3000.0),
          .edge_n_per_mm = between(5.0, 40.0),
          .lag_s = between(0.015, 0.06),
          .idle_linear = between(0.02, 0.08),
          .idle_square = between(2e-6, 1e-5),
          .noise = between(0.04, 0.09)};
}

struct Pass {
  double feed_per_tooth_mm = 0.0;  // 0: in the air
  double depth_mm = 0.0;
  double entry_rad = 0.0;
  double exit_rad = 0.0;
};

// Slots and side cuts up and down, between ways in the air.
const std::vector<Pass> passes{{0.0, 0.0, 0.0, 0.0},
                               {0.05, 2.0, 0.0, std::numbers::pi},
                               {0.12, 2.0, 0.0, std::numbers::pi},
                               {0.12, 3.0, 0.0, 0.5 * std::numbers::pi},
                               {0.0, 0.0, 0.0, 0.0},
                               {0.2, 3.0, 0.0, 0.5 * std::numbers::pi},
                               {0.08, 4.0, 0.6 * std::numbers::pi, std::numbers::pi},
                               {0.25, 1.5, 0.0, std::numbers::pi},
                               {0.15, 5.0, 0.7 * std::numbers::pi, std::numbers::pi}};

// Power of the cut with the teeth at an angle, W.
double cut_w(const HiddenMill& mill, const Pass& pass, double angle, double turns_per_s) {
  double force = 0.0;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double at =
        std::fmod(angle + 2.0 * std::numbers::pi * tooth / teeth, 2.0 * std::numbers::pi);
    if (pass.feed_per_tooth_mm <= 0.0 || at < pass.entry_rad || at > pass.exit_rad) continue;
    const double chip = pass.feed_per_tooth_mm * std::sin(at);
    force += pass.depth_mm * (mill.force_n_per_mm2 * chip + mill.edge_n_per_mm);
  }
  return force * 2.0 * std::numbers::pi * radius_mm * turns_per_s * 1e-3;
}

// What the log knows at the end of a cycle: volume and edge in closed form.
MillingRow row_of(const Pass& pass, double rev_per_min) {
  const double turns_per_s = rev_per_min / 60.0;
  const double width = radius_mm * (std::cos(pass.entry_rad) - std::cos(pass.exit_rad));
  const double arc = radius_mm * (pass.exit_rad - pass.entry_rad);
  return {.rev_per_min = rev_per_min,
          .removal_mm3_per_s = width * pass.depth_mm * pass.feed_per_tooth_mm * teeth * turns_per_s,
          .rubbing_mm2_per_s = pass.depth_mm * teeth * arc * turns_per_s};
}

// The lag is solved in steps of a twentieth of a millisecond; passes end anywhere in a cycle.
MillingRecord recorded(const HiddenMill& mill, std::mt19937& random) {
  constexpr int steps_of_cycle = 20;
  constexpr int cycles_of_poll = 10;
  constexpr int pass_cycles = 1200;
  constexpr double dt = 0.001 / steps_of_cycle;
  std::normal_distribution<double> gauss(0.0, 1.0);
  std::uniform_int_distribution<int> rest(0, steps_of_cycle - 1);
  MillingRecord record;
  double power_w = 0.0;
  double angle = 0.0;
  int step = 0;
  for (const double rev_per_min : {2937.0, 5381.0}) {
    const double turns_per_s = rev_per_min / 60.0;
    const double idle = rev_per_min * (mill.idle_linear + mill.idle_square * rev_per_min);
    for (const Pass& pass : passes) {
      for (int left = pass_cycles * steps_of_cycle + rest(random); left > 0; --left) {
        angle =
            std::fmod(angle + 2.0 * std::numbers::pi * turns_per_s * dt, 2.0 * std::numbers::pi);
        const double wanted = cut_w(mill, pass, angle, turns_per_s);
        power_w += (wanted - power_w) * (1.0 - std::exp(-dt / mill.lag_s));
        if (++step % steps_of_cycle != 0) continue;
        record.rows.push_back(row_of(pass, rev_per_min));
        if (step % (steps_of_cycle * cycles_of_poll) == 0)
          record.rows.back().power_w =
              std::round(idle + power_w * (1.0 + mill.noise * gauss(random)));
      }
    }
  }
  return record;
}

// 95 % intervals: of a hundred values at least ninety lie inside.
TEST(MillingFit, ItsIntervalsHoldTheHiddenValues) {
  std::mt19937 random(20266);
  int inside = 0;
  int all = 0;
  double worst_force = 0.0;
  for (int plant = 0; plant < 20; ++plant) {
    const HiddenMill mill = hidden_mill(random);
    const auto fit = fit_milling(recorded(mill, random));
    ASSERT_TRUE(fit.has_value()) << fit.error();
    const bool hits[] = {
        fit->force_n_per_mm2.contains(mill.force_n_per_mm2),
        fit->edge_n_per_mm.contains(mill.edge_n_per_mm), fit->lag_s.contains(mill.lag_s),
        fit->idle_linear.contains(mill.idle_linear), fit->idle_square->contains(mill.idle_square)};
    for (const bool hit : hits) {
      inside += hit ? 1 : 0;
      ++all;
    }
    worst_force =
        std::max(worst_force, std::abs(fit->force_n_per_mm2.value / mill.force_n_per_mm2 - 1.0));
    // The teeth add their own swing.
    EXPECT_GT(fit->noise, 0.8 * mill.noise);
  }
  RecordProperty("inside", std::to_string(inside));
  RecordProperty("force_worst", std::to_string(worst_force));
  EXPECT_GE(inside, all * 9 / 10);
  EXPECT_LT(worst_force, 0.05);
}

// Most of the power comes from something else than the cut.
TEST(MillingFit, RefusesAPowerThatDoesNotFollowTheCut) {
  std::mt19937 random(2);
  HiddenMill mill = hidden_mill(random);
  mill.noise = 0.8;
  const auto fit = fit_milling(recorded(mill, random));
  ASSERT_FALSE(fit.has_value());
  EXPECT_NE(fit.error().find("does not follow the cut"), std::string::npos) << fit.error();
}

TEST(MillingFit, SaysWhatTheRecordLacks) {
  std::mt19937 random(1);
  const HiddenMill mill = hidden_mill(random);
  MillingRecord record = recorded(mill, random);
  for (MillingRow& row : record.rows) row.rubbing_mm2_per_s = row.removal_mm3_per_s = 0.0;
  EXPECT_NE(fit_milling(record).error().find("in the cut"), std::string::npos);
  record = recorded(mill, random);
  std::erase_if(record.rows, [](const MillingRow& row) { return row.removal_mm3_per_s <= 0.0; });
  EXPECT_NE(fit_milling(record).error().find("idling"), std::string::npos);
  record = recorded(mill, random);
  for (MillingRow& row : record.rows) row.removal_mm3_per_s = 0.1 * row.rubbing_mm2_per_s;
  EXPECT_NE(fit_milling(record).error().find("one thickness"), std::string::npos);
}

}  // namespace
}  // namespace stanok::process
