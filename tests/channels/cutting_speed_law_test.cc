// Laws of cutting speed with feed, from the program to the setpoints: v_n to v_k and S_n to S_k in
// increments at the same places, n = 1000 v / (pi D) at each diameter, against the sum over the
// increments that is made here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/machine/turning_bench.h"

namespace stanok::channels {
namespace {

using testing::CutCycle;
using testing::CutTime;
using testing::FeedOf;
using testing::MachineBench;
using testing::per_min;
using testing::per_rev;
using testing::word_unless_zero;

constexpr double n_max = 3000.0;

// A case states v_k and S_k, or dv, dS and dl; what is 0 stands not in the program.
struct CuttingSpeedLawCase {
  const char* name;
  const char* motion;            // from its first diameter and Z0
  double length;                 // of the motion, along which the diameter changes evenly
  double diameter, diameter_to;  // mm
  bool per_revolution;
  double v_first, v_last, v_step;
  double feed_first, feed_last, feed_step;
  double dl;
  double n_min = 10.0;
};

std::string program_of(const CuttingSpeedLawCase& c) {
  return "G0 X" + std::to_string(c.diameter) + " Z0\nG4 P0.01\nG97 S" +
         std::to_string(testing::speed_of_cut(c.v_first, c.diameter, c.n_min, n_max)) + " M3\n" +
         (c.per_revolution ? "G95 " : "G94 ") + c.motion + word_unless_zero("v_n", c.v_first) +
         word_unless_zero("v_k", c.v_last) + word_unless_zero("dv", c.v_step) +
         word_unless_zero("S_n", c.feed_first) + word_unless_zero("S_k", c.feed_last) +
         word_unless_zero("dS", c.feed_step) + word_unless_zero("dl", c.dl) + "\nM5\nM30\n";
}

class CuttingSpeedLaw : public ::testing::TestWithParam<CuttingSpeedLawCase> {};

TEST_P(CuttingSpeedLaw, StepsCuttingSpeedAndFeedAtTheSamePlaces) {
  const CuttingSpeedLawCase& c = GetParam();
  const double change = c.feed_last - c.feed_first;
  const double count = c.v_last > 0.0 ? std::round(std::abs(change) / c.feed_step) : 1e9;
  const double dl =
      c.dl != 0.0 ? std::abs(c.dl) : 0.001 * std::floor(c.length / count / 0.001 + 1e-6);
  const double dv = c.v_last > 0.0 ? (c.v_last - c.v_first) / count : c.v_step;
  const double ds = std::copysign(c.feed_step, c.v_last > 0.0 ? change : c.dl);
  const auto diameter_at = [&](double way) {
    return c.diameter + (c.diameter_to - c.diameter) * way / c.length;
  };
  const double increments = std::min(count, std::ceil(c.length / dl - 1e-6) - 1.0);
  const int last = static_cast<int>(increments);
  CutTime wanted;
  double v = c.v_first;
  double feed = c.feed_first;
  for (int k = 0; k <= last; ++k) {
    const double start = wanted.way();
    wanted.add(k < last ? dl : c.length - start, [&](double way) {
      const double n = testing::speed_of_cut(v, diameter_at(start + way), c.n_min, n_max);
      return c.per_revolution ? feed * n : feed;
    });
    v += dv;
    feed += ds;
  }

  MachineBench bench(testing::strong_lathe(c.n_min));
  const auto cycles = testing::cycles_of_cut(bench, program_of(c));
  testing::expect_cut(cycles, wanted, c.per_revolution ? FeedOf::revolution : FeedOf::time);
  for (const CutCycle& one : cycles) {
    if (one.is_last) break;
    const auto k = static_cast<double>(one.process.increments);
    EXPECT_GE(k, std::min(increments, std::floor((one.way - 1e-3) / dl)));
    EXPECT_LE(k, std::min(increments, std::floor((one.way + 1e-3) / dl)));
    const double n = testing::speed_of_cut(c.v_first + k * dv, 2.0 * one.x, c.n_min, n_max);
    EXPECT_NEAR(one.process.spindle_rev_per_min, n, 1e-9 * n);
    EXPECT_NEAR(one.process.cutting_speed_m_per_min, std::numbers::pi * 2.0 * one.x * n / 1000.0,
                1e-9);
    if (!c.per_revolution) {
      EXPECT_NEAR(one.process.feed_mm_per_min, c.feed_first + k * ds, 1e-9);
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(static_cast<double>(cycles.back().process.increments), increments);
  const double steps = std::min(count, std::floor(c.length / dl + 1e-6));
  const double n_end = testing::speed_of_cut(c.v_first + steps * dv, c.diameter_to, c.n_min, n_max);
  EXPECT_NEAR(cycles.back().process.spindle_rev_per_min, n_end, 1e-9 * n_end);
}

const CuttingSpeedLawCase cutting_speed_law_cases[] = {
    // Along a cylinder.
    {"both_rise", "G1 Z-10", 10, 60, 60, per_min, 100, 0, 2, 90, 0, 2, 0.25},
    {"speed_falls", "G1 Z-10", 10, 60, 60, per_min, 180, 0, -2.5, 120, 0, 1.5, 0.2},
    {"feed_falls", "G1 Z-8", 8, 45, 45, per_min, 60, 0, 1, 200, 0, 2, -0.125},
    {"fine_steps", "G1 Z-5", 5, 60, 60, per_min, 150, 0, 0.01, 150, 0, 0.1, 0.001},
    {"ends", "G1 Z-9", 9, 60, 60, per_min, 90, 140, 0, 100, 160, 2, 0},
    {"ends_cross", "G1 Z-7", 7, 80, 80, per_min, 220, 120, 0, 80, 130, 2, 0},
    {"ends_before_the_block", "G1 Z-12", 12, 60, 60, per_min, 90, 120, 0, 90, 120, 1.5, 0.3},
    {"block_ends_before", "G1 Z-4", 4, 60, 60, per_min, 100, 200, 0, 90, 150, 1, 0.2},
    // Over changing diameters.
    {"facing", "G1 X20", 20, 60, 20, per_min, 80, 0, 1, 150, 0, 1, 0.5},
    {"facing_outwards", "G1 X80", 25, 30, 80, per_min, 120, 0, -1, 150, 0, 2, -0.5},
    {"facing_to_highest_speed", "G1 X4", 18, 40, 4, per_min, 100, 160, 0, 150, 210, 3, 0},
    {"lowest_speed_outwards", "G1 X90", 30, 30, 90, per_min, 40, 20, 0, 180, 120, 2, 0, 150},
    {"taper", "G1 X52 Z-3", 5, 60, 52, per_min, 150, 180, 0, 150, 75, 2.5, 0},
    // Per revolution.
    {"rev_cylinder", "G1 Z-6", 6, 60, 60, per_rev, 100, 0, 1, 0.1, 0, 0.002, 0.25},
    {"rev_facing", "G1 X20", 20, 60, 20, per_rev, 80, 120, 0, 0.2, 0.12, 0.002, 0},
    {"rev_facing_outwards", "G1 X80", 25, 30, 80, per_rev, 100, 80, 0, 0.1, 0.2, 0.005, 0},
    {"rev_highest_speed", "G1 X6", 17, 40, 6, per_rev, 120, 0, 2, 0.08, 0, 0.002, 0.5},
    {"rev_lowest_speed", "G1 X90", 30, 30, 90, per_rev, 40, 20, 0, 0.3, 0.4, 0.004, 0, 150},
    {"rev_taper", "G1 X52 Z-3", 5, 60, 52, per_rev, 150, 0, -2, 0.06, 0, 0.004, 0.2},
};

INSTANTIATE_TEST_SUITE_P(Cases, CuttingSpeedLaw, ::testing::ValuesIn(cutting_speed_law_cases),
                         [](const auto& with) { return std::string(with.param.name); });

}  // namespace
}  // namespace stanok::channels
