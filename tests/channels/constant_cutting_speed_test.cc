// G96, G95 and their limits, exactly: on a spindle that has every speed at once each cycle has
// n = 1000 v / (pi D) within its limits at the diameter of the setpoint, and the path takes the
// time and the revolutions that this makes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/cycle.h"
#include "tests/support/machine/turning_bench.h"

namespace stanok::channels {
namespace {

using testing::CutCycle;
using testing::CutTime;
using testing::FeedOf;
using testing::MachineBench;

// A part of the contour: its diameter changes evenly, or along a quarter of a circle to the far
// side of its centre.
struct Part {
  double length;
  double diameter, diameter_to;
  double radius = 0.0;  // of the quarter; 0: a line

  [[nodiscard]] double diameter_at(double way) const {
    if (radius > 0.0) return diameter + 2.0 * radius * std::sin(way / radius);
    return diameter + (diameter_to - diameter) * way / length;
  }
};

struct TurningCase {
  const char* name;
  const char* head;    // up to the spindle that turns
  const char* motion;  // from `head` on
  double v;            // m/min; 0: a speed
  double n;            // rev/min, of G97
  double feed;         // mm/rev
  double n_min, n_max;
  std::vector<Part> parts;
};

class Turning : public ::testing::TestWithParam<TurningCase> {};

TEST_P(Turning, HasItsSpeedItsTimeAndItsRevolutions) {
  const TurningCase& c = GetParam();
  const auto speed_at = [&](double diameter) {
    return c.v > 0.0 ? testing::speed_of_cut(c.v, diameter, c.n_min, c.n_max) : c.n;
  };
  CutTime wanted;
  for (const Part& part : c.parts)
    wanted.add(part.length, [&](double way) { return c.feed * speed_at(part.diameter_at(way)); });

  MachineBench bench(testing::strong_lathe(c.n_min));
  const auto cycles = testing::cycles_of_cut(
      bench, std::string("G61\n") + c.head + "\nG4 P0.01\n" + c.motion + "\nM5\nM30\n");
  testing::expect_cut(cycles, wanted, FeedOf::revolution);
  double revolutions = 0.0;
  double n_before = speed_at(c.parts.front().diameter);
  for (const CutCycle& one : cycles) {
    const double n = std::abs(one.process.spindle_rev_per_min);
    const double due = speed_at(2.0 * std::abs(one.x));
    EXPECT_NEAR(n, due, 1e-9 * due) << "at " << one.way << " mm, diameter " << 2.0 * one.x;
    revolutions += 0.5 * (n + n_before) / 60.0 * testing::cycle_s;
    n_before = n;
    if (one.is_last) break;
    EXPECT_NEAR(one.process.cutting_speed_m_per_min,
                std::numbers::pi * 2.0 * std::abs(one.x) * n / 1000.0, 1e-9);
    if (::testing::Test::HasFailure()) return;
  }
  // L / f revolutions, whatever the speed does; the cut ends within its last cycle.
  const double cycle_turns = n_before / 60.0 * testing::cycle_s;
  const double late_turns = wanted.variation() / c.feed * testing::cycle_s;
  EXPECT_NEAR(revolutions, wanted.way() / c.feed, cycle_turns + late_turns + 1e-3);
}

constexpr double quarter = 0.5 * std::numbers::pi;

const TurningCase turning_cases[] = {
    {"facing", "G0 X80 Z0\nG96 S150 M3", "G95 G1 X20 F0.2", 150, 0, 0.2, 50, 3000, {{30, 80, 20}}},
    {"facing_outwards",
     "G0 X20 Z0\nG96 S150 M3",
     "G95 G1 X80 F0.2",
     150,
     0,
     0.2,
     50,
     3000,
     {{30, 20, 80}}},
    {"facing_counter_clockwise",
     "G0 X80 Z0\nG96 S120 M4",
     "G95 G1 X30 F0.15",
     120,
     0,
     0.15,
     50,
     3000,
     {{25, 80, 30}}},
    {"highest_speed_of_the_spindle",
     "G0 X60 Z0\nG96 S200 M3",
     "G95 G1 X4 F0.1",
     200,
     0,
     0.1,
     50,
     3000,
     {{28, 60, 4}}},
    {"to_the_centre",
     "G0 X30 Z0\nG96 S200 M3",
     "G95 G1 X0 F0.1",
     200,
     0,
     0.1,
     50,
     3000,
     {{15, 30, 0}}},
    {"limit_of_its_block",
     "G0 X80 Z0\nG96 S150 D1500 M3",
     "G95 G1 X20 F0.2",
     150,
     0,
     0.2,
     50,
     1500,
     {{30, 80, 20}}},
    {"limit_before",
     "G0 X80 Z0\nG92 S1200\nG96 S150 M3",
     "G95 G1 X20 F0.2",
     150,
     0,
     0.2,
     50,
     1200,
     {{30, 80, 20}}},
    {"lowest_speed",
     "G0 X90 Z0\nG96 S40 M3",
     "G95 G1 X30 F0.3",
     40,
     0,
     0.3,
     200,
     3000,
     {{30, 90, 30}}},
    {"both_limits",
     "G0 X90 Z0\nG96 S60 D500 M3",
     "G95 G1 X20 F0.3",
     60,
     0,
     0.3,
     300,
     500,
     {{35, 90, 20}}},
    {"cylinder",
     "G0 X50 Z0\nG96 S100 M3",
     "G95 G1 Z-25 F0.25",
     100,
     0,
     0.25,
     50,
     3000,
     {{25, 50, 50}}},
    {"taper",
     "G0 X40 Z0\nG96 S110 M3",
     "G95 G1 X64 Z-16 F0.2",
     110,
     0,
     0.2,
     50,
     3000,
     {{20, 40, 64}}},
    {"quarter_circle",
     "G0 X60 Z0\nG96 S140 M3",
     "G95 G3 X80 Z-10 R10 F0.18",
     140,
     0,
     0.18,
     50,
     3000,
     {{10 * quarter, 60, 80, 10}}},
    {"contour",
     "G0 X40 Z0\nG96 S100 M3",
     "G95 G1 Z-6 F0.2\nX52 Z-14\nZ-18\nX70",
     100,
     0,
     0.2,
     50,
     3000,
     {{6, 40, 40}, {10, 40, 52}, {4, 52, 52}, {9, 52, 70}}},
    {"in_and_out_again",
     "G0 X60 Z0\nG96 S130 M3",
     "G95 G1 X30 F0.2\nX60",
     130,
     0,
     0.2,
     50,
     3000,
     {{15, 60, 30}, {15, 30, 60}}},
    {"radius_programming",
     "G8 G0 X40 Z0\nG96 S150 M3",
     "G95 G1 X10 F0.2",
     150,
     0,
     0.2,
     50,
     3000,
     {{30, 80, 20}}},
    {"diameter_programming",
     "G7 G0 X40 Z0\nG96 S150 M3",
     "G95 G1 X10 F0.2",
     150,
     0,
     0.2,
     50,
     3000,
     {{15, 40, 10}}},
    {"inches",
     "G20 G0 X3 Z0\nG96 S400 M3",
     "G95 G1 X1 F0.008",
     121.92,
     0,
     0.2032,
     50,
     3000,
     {{25.4, 76.2, 25.4}}},
    {"another_tool",
     "G10 L1 P2 X8 Z3\nT2\nG0 X70 Z0\nG96 S125 M3",
     "G95 G1 X26 F0.2",
     125,
     0,
     0.2,
     50,
     3000,
     {{22, 70, 26}}},
    {"tool_changed_under_it",
     "G10 L1 P2 X8 Z3\nG0 X70 Z0\nG96 S125 M3\nT2\nG0 X66 Z0",
     "G95 G1 X26 F0.2",
     125,
     0,
     0.2,
     50,
     3000,
     {{20, 66, 26}}},
    {"shifted_zero",
     "G52 X10\nG0 X60 Z0\nG96 S125 M3",
     "G95 G1 X26 F0.2",
     125,
     0,
     0.2,
     50,
     3000,
     {{17, 60, 26}}},
    {"behind_the_centre",
     "G0 X-60 Z0\nG96 S125 M3",
     "G95 G1 X-26 F0.2",
     125,
     0,
     0.2,
     50,
     3000,
     {{17, 60, 26}}},
    {"speed_again",
     "G0 X60 Z0\nG96 S150 M3\nG97 S900",
     "G95 G1 X30 F0.2",
     0,
     900,
     0.2,
     50,
     3000,
     {{15, 60, 30}}},
    {"speed_stays_without_s",
     "G0 X60 Z0\nG96 S150 M3\nG97",
     "G95 G1 X30 F0.2",
     0,
     150000.0 / (std::numbers::pi * 60.0),
     0.2,
     50,
     3000,
     {{15, 60, 30}}},
    {"another_cutting_speed",
     "G0 X60 Z0\nG96 S150 M3\nS90",
     "G95 G1 X30 F0.2",
     90,
     0,
     0.2,
     50,
     3000,
     {{15, 60, 30}}},
};

INSTANTIATE_TEST_SUITE_P(Cases, Turning, ::testing::ValuesIn(turning_cases),
                         [](const auto& with) { return std::string(with.param.name); });

}  // namespace
}  // namespace stanok::channels
