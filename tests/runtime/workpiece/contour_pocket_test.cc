// G150 on the virtual workpiece: what a pocket with islands leaves, ray by ray, against the exact
// geometry of its outline, islands and tool.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/runtime/workpiece/measuring_bench.h"

namespace stanok::runtime {
namespace {

using ::testing::IsEmpty;

constexpr double top = 0.0;
constexpr double block_below = -20.0;
constexpr double resolution = 0.2;

struct Pocket {
  // Signed distance to the walls, below zero in the walls and islands.
  std::function<double(double x, double y)> inside;
  double depth = 0.0;
};

class ContourPocket : public ::testing::Test {
 protected:
  // On a block of 100 x 100 x 20 about the origin, with tool 2 of radius 5.
  void mill(const std::string& blocks, const std::string& subprograms) {
    bench.options.workpieces = std::make_shared<SimulatedWorkpieces>(
        bench.options.file, simulation::memory_default,
        [](int, const std::string& code, const std::string& text) {
          ADD_FAILURE() << code << " " << text;
        });
    bench.tool(2).overhang = 40.0;
    bench.tool(2).flute_length = 30.0;
    bench.run_to_end("#workpiece (0, 0.2, 0, 100, 100, 20, 50, 50, 20)\nT2 M6\nG43\nS3000 M3\n" +
                     blocks + "G0 Z50\nM30\n" + subprograms);
  }
  [[nodiscard]] const simulation::Workpiece& part() {
    return *bench.options.workpieces->feeds()[0]->follower().workpieces().at(0);
  }

  // Each ray along Z: full where the tool cannot be without touching a wall, down to the floor
  // where it can be anywhere over it. What lies between is what a round tool leaves in corners, or
  // nearer to the edge than chords and path may be.
  void expect_pocket(const Pocket& pocket, double tolerance) {
    const simulation::Material& material = part().material();
    const simulation::Grid& grid = material.grid();
    const auto deepest = [&](double x, double y) { return pocket.inside(x, y); };
    int gouged = 0;
    int left = 0;
    int floors = 0;
    for (int j = 0; j < grid.count[1]; ++j) {
      for (int i = 0; i < grid.count[0]; ++i) {
        const double x = grid.middle(0, i) - 50.0;
        const double y = grid.middle(1, j) - 50.0;
        const double length = material.family(2).overlap(material.ray(2, i, j), 0.0, 20.0);
        if (deepest(x, y) < -tolerance && length < 20.0 - 1e-4) ++gouged;
        if (!reached(pocket, x, y, tolerance)) continue;
        ++floors;
        if (std::abs(length - (20.0 + pocket.depth)) > 1e-3) ++left;
      }
    }
    EXPECT_EQ(gouged, 0);
    EXPECT_EQ(left, 0) << "of " << floors;
    EXPECT_GT(floors, 1000);
  }
  // Whether some place of the tool's middle, a tolerance away from touching, covers the point.
  static bool reached(const Pocket& pocket, double x, double y, double tolerance) {
    constexpr double radius = 5.0;
    for (double r = 0.0; r < radius - tolerance; r += 0.5) {
      for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 24;
        if (pocket.inside(x + r * std::cos(angle), y + r * std::sin(angle)) > radius + tolerance)
          return true;
      }
    }
    return false;
  }

  MeasuringBench bench;
};

double box_distance(double x, double y, double half_x, double half_y) {
  const double dx = std::abs(x) - half_x;
  const double dy = std::abs(y) - half_y;
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0);
}

// 80 x 80 with a square island of 20 x 20 at (10, 5), in three levels with a finish.
TEST_F(ContourPocket, WithASquareIslandLeavesWhatTheDrawingSays) {
  mill(
      "G0 X-20 Y-20 Z10\n"
      "G150 P500 X-20 Y-20 Z-6 R1 Q2.5 J7 K0.3 G41 D2 F3000\n",
      "O500\nG1 Y-40\nX40\nY40\nX-40\nY3\nX0\nY15\nX20\nY-5\nX0\nY7\nX-40\nY-40\nX-20\nM99\n");
  expect_pocket({.inside =
                     [](double x, double y) {
                       return std::min(-box_distance(x, y, 40, 40),
                                       box_distance(x - 10, y - 5, 10, 10));
                     },
                 .depth = -6.0},
                0.01);
  EXPECT_THAT(part().report().findings(), IsEmpty());
}

// A circle of radius 45 with two round islands, milled clockwise with G42, lines along Y.
TEST_F(ContourPocket, WithRoundIslandsOnTheOtherSide) {
  mill(
      "G0 X0 Y0 Z10\n"
      "G150 P600 X0 Y-30 Z-4 R1 Q10 I8 G42 D2 F3000\n",
      "O600\nG1 X45 Y0\nG2 X-45 R45\nG1 X-35\nG3 X-15 R10\nX-35 R10\nG1 X-45\nG2 X45 R45\nG1 X35\n"
      "G3 X15 R10\nX35 R10\nG1 X45\nM99\n");
  expect_pocket({.inside =
                     [](double x, double y) {
                       return std::min({45.0 - std::hypot(x, y), std::hypot(x - 25, y) - 10.0,
                                        std::hypot(x + 25, y) - 10.0});
                     },
                 .depth = -4.0},
                0.01);
  EXPECT_THAT(part().report().findings(), IsEmpty());
}

}  // namespace
}  // namespace stanok::runtime
