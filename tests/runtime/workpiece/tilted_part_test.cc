// A part milled in five planes against the half-spaces that its drawing has.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <numbers>

#include "simulation/surface_mesh.h"
#include "tests/runtime/workpiece/measuring_bench.h"

namespace stanok::runtime {
namespace {

using Point = Eigen::Vector3d;

constexpr double ray_spacing = 0.3;  // mm
constexpr double slope_deg = 25.0;
constexpr double begin_of_slope = 20.0;  // from the middle

struct HalfSpace {
  Point normal;
  double at = 0.0;

  [[nodiscard]] double above(const Point& point) const { return normal.dot(point) - at; }
};

// The top, four slopes that fall to the sides from lines in it, and what is left of the blank.
std::vector<HalfSpace> drawn_part() {
  const double slope = slope_deg * std::numbers::pi / 180.0;
  std::vector<HalfSpace> part{{Point::UnitZ(), 0.0}};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto turn = Eigen::AngleAxisd(quarter * std::numbers::pi / 2.0, Point::UnitZ());
    const Point normal = turn * Point(0.0, -std::sin(slope), std::cos(slope));
    part.push_back({normal, normal.dot(turn * Point(0.0, -begin_of_slope, 0.0))});
  }
  for (const Point& side : {Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0)})
    part.push_back({side, 30.0});
  part.push_back({-Point::UnitZ(), 39.0});
  return part;
}

std::string top_and_slopes() {
  std::string text =
      "G54\n#workpiece (0, 0.3, 0, 60, 60, 40, 30, 30, 39)\nT2 M6\nS6000 M3\nG43\nF4000\n"
      "G53 G0 Z0\nG0 X-40 Y-25\nZ0\n";
  for (int row = 0; row < 6; ++row) {
    const std::string y = std::to_string(-25 + 10 * row);
    text += "G1 Y" + y + "\nX" + (row % 2 == 0 ? "40" : "-40") + "\n";
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    const std::array<const char*, 4> origins{"X0 Y-20", "X20 Y0", "X0 Y20", "X-20 Y0"};
    text += "G53 G0 Z0\nG68.2 " + std::string(origins[static_cast<std::size_t>(quarter)]) +
            " Z0 I" + std::to_string(90 * quarter) +
            " J25 K0\nG53.1\nG0 X-40 Y-6 Z40\nG1 Z0\nX40\nY-12\nX-40\nG0 Z40\nG69\n";
  }
  return text + "G53 G0 Z0\nM30\n";
}

// Away from edges, which the mesh bevels, a point of the surface lies on one face.
TEST(TiltedPart, IsAsTrueOnItsSlopesAsOnItsTop) {
  MeasuringBench bench("trunnion.toml");
  bench.options.workpieces = std::make_shared<SimulatedWorkpieces>(
      bench.options.file, simulation::memory_default,
      [](int, const std::string& code, const std::string& text) {
        ADD_FAILURE() << code << " " << text;
      });
  bench.run_to_end(top_and_slopes());
  const auto& workpiece = *bench.options.workpieces->feeds()[0]->follower().workpieces().at(0);
  EXPECT_TRUE(workpiece.report().findings().empty());
  const std::vector<HalfSpace> part = drawn_part();
  std::array<double, 5> off{};
  std::array<int, 5> points{};
  for (const auto& vertex : simulation::surface_of(workpiece.material()).points) {
    const Point point = vertex.cast<double>() - Point(30.0, 30.0, 39.0);
    std::size_t face = 0;
    double second = -1e9;
    for (std::size_t k = 1; k < part.size(); ++k) {
      const bool is_higher = part[k].above(point) > part[face].above(point);
      second = std::max(second, part[is_higher ? face : k].above(point));
      if (is_higher) face = k;
    }
    if (face >= off.size() || second > -2.0 * ray_spacing) continue;
    off[face] = std::max(off[face], std::abs(part[face].above(point)));
    ++points[face];
  }
  for (std::size_t face = 0; face < off.size(); ++face) {
    EXPECT_GT(points[face], 500) << "face " << face;
    EXPECT_LT(off[face], 0.0003 * ray_spacing) << "face " << face;
  }
}

}  // namespace
}  // namespace stanok::runtime
