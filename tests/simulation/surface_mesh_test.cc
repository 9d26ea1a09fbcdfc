// Surfaces are closed: every edge belongs to two triangles that run along it in opposite senses.
#include "simulation/surface_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "simulation/cube_cases.h"
#include "simulation/offcuts.h"
#include "tests/simulation/analytic_parts.h"

namespace stanok::simulation {
namespace {

// How often each directed edge runs, less how often the other way.
int open_edges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = triangle[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  int open = 0;
  for (const auto& [edge, sum] : balance) open += sum != 0 ? 1 : 0;
  return open;
}

TEST(SurfaceMesh, IsClosedForRandomCuts) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-2.0, 12.0);
    std::normal_distribution<double> normal;
    Blank blank = testing::box(10.0, 9.0, 8.0);
    blank.resolution = 0.5;
    Workpiece workpiece(blank, *grid_of(blank));
    ToolShape shape = testing::rotating(seed % 2 == 0 ? ToolKind::ball : ToolKind::flat, 1.3);
    const MillingTool tool = workpiece.milling_tool(shape);
    for (int cut = 0; cut < 12; ++cut) {
      const Vector axis = Vector(normal(random), normal(random), normal(random)).normalized();
      const ToolPlace from{{place(random), place(random), place(random)}, axis};
      const ToolPlace to{{place(random), place(random), place(random)}, axis};
      workpiece.mill(tool, from, to, testing::at_feed(1));
    }
    const Mesh mesh = surface_of(workpiece.material());
    EXPECT_EQ(open_edges(mesh), 0) << seed;
    // Sharp edges are bevelled by part of a cell.
    const double volume = workpiece.material().volume();
    EXPECT_NEAR(mesh.volume(), volume, 0.15 * volume + 5.0) << seed;
  }
}

// A cut through the block leaves 6 of its 20 mm on one side, and a flat plate is cut off above.
TEST(SurfaceMesh, LosesItsOffcuts) {
  Blank blank = testing::box(20.0, 10.0, 10.0);
  blank.resolution = 0.25;
  Workpiece workpiece(blank, *grid_of(blank));
  testing::mill_along(workpiece, testing::rotating(ToolKind::flat, 1.0), Vector::UnitZ(),
                      {{7.0, -5.0, -1.0}, {7.0, 15.0, -1.0}});
  testing::mill_along(workpiece, testing::rotating(ToolKind::flat, 1.0), Vector::UnitX(),
                      {{7.5, -5.0, 8.0}, {7.5, 15.0, 8.0}});
  Mesh mesh = surface_of(workpiece.material());
  const double whole = mesh.volume();
  const Offcuts offcuts = take_off_offcuts(mesh);
  EXPECT_EQ(offcuts.count, 2U);
  EXPECT_NEAR(offcuts.volume_mm3, 6.0 * 100.0 + 12.0 * 10.0 * 1.0, 15.0);
  EXPECT_NEAR(mesh.volume(), whole - offcuts.volume_mm3, 1e-3);
  EXPECT_NEAR(mesh.volume(), 12.0 * 10.0 * 7.0, 15.0);
  EXPECT_EQ(open_edges(mesh), 0);
  EXPECT_EQ(take_off_offcuts(mesh).count, 0U);
}

TEST(SurfaceMesh, HasTheVolumeOfTheBlankOutwards) {
  Blank blank = testing::bar(20.0, 8.0, 15.0);
  blank.resolution = 0.25;
  const Mesh mesh = surface_of(Material(blank, *grid_of(blank)));
  EXPECT_EQ(open_edges(mesh), 0);
  EXPECT_NEAR(mesh.volume(), volume_of(blank), 0.01 * volume_of(blank));
}

// A corner alone is one triangle, its opposite case the same turned over; all and none are nothing.
TEST(CubeCases, AreWhatTheDrawingShows) {
  EXPECT_TRUE(cube_triangles(0).empty());
  EXPECT_TRUE(cube_triangles(255).empty());
  for (unsigned corner = 0; corner < 8; ++corner) {
    EXPECT_EQ(cube_triangles(1U << corner).size(), 1U);
    EXPECT_EQ(cube_triangles(255U - (1U << corner)).size(), 1U);
  }
  EXPECT_EQ(cube_triangles(0b00001111).size(), 2U);
  EXPECT_EQ(cube_triangles(0b01101001).size(), 4U);  // four corners, no two beside each other
}

}  // namespace
}  // namespace stanok::simulation
