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

// All bricks of a workpiece.
std::vector<Patch> patches_of(const Workpiece& workpiece) {
  std::vector<Patch> patches;
  const CutMarks& marks = *workpiece.material().marks();
  for (std::size_t brick = 0; brick < marks.bricks(); ++brick)
    patches.push_back(patch_of(workpiece.material(), marks.cubes_of(brick)));
  return patches;
}

double volume_of(const std::vector<Patch>& patches) {
  double volume = 0.0;
  for (const Patch& patch : patches) volume += patch.mesh.volume();
  return volume;
}

std::size_t triangles_of(const std::vector<Patch>& patches) {
  std::size_t count = 0;
  for (const Patch& patch : patches) count += patch.mesh.triangles.size();
  return count;
}

Workpiece marked_plate(double x, double y, double z, double resolution) {
  Blank blank = testing::box(x, y, z);
  blank.resolution = resolution;
  Workpiece workpiece(blank, *grid_of(blank));
  workpiece.mark_cuts();
  return workpiece;
}

// Parts of a closed surface enclose, put together, what the whole does.
TEST(SurfaceMesh, IsTheSameInPatches) {
  Workpiece workpiece = marked_plate(40.0, 30.0, 20.0, 0.4);
  testing::mill_along(workpiece, testing::rotating(ToolKind::ball, 3.0), Vector::UnitZ(),
                      {{-5.0, 12.0, 15.0}, {45.0, 21.0, 11.0}});
  const Mesh whole = surface_of(workpiece.material());
  const auto patches = patches_of(workpiece);
  EXPECT_GT(patches.size(), 8U);
  EXPECT_EQ(triangles_of(patches), whole.triangles.size());
  EXPECT_NEAR(volume_of(patches), whole.volume(), 1e-3);
}

// A slot of 4 mm across a plate whose left half was cut by another tool.
TEST(CutMarks, NameTheToolThatMadeASurface) {
  Workpiece workpiece = marked_plate(40.0, 20.0, 10.0, 0.5);
  Circumstances circumstances = testing::at_feed(1);
  const MillingTool flat = workpiece.milling_tool(testing::rotating(ToolKind::flat, 2.0));
  circumstances.tool = 7;
  workpiece.mill(flat, {{10.0, -5.0, 6.0}, Vector::UnitZ()}, {{10.0, 25.0, 6.0}, Vector::UnitZ()},
                 circumstances);
  circumstances.tool = 31;
  workpiece.mill(flat, {{30.0, -5.0, 3.0}, Vector::UnitZ()}, {{30.0, 25.0, 3.0}, Vector::UnitZ()},
                 circumstances);
  std::size_t floors = 0;
  for (const Patch& patch : patches_of(workpiece)) {
    ASSERT_EQ(patch.tools.size(), patch.mesh.points.size());
    for (std::size_t k = 0; k < patch.tools.size(); ++k) {
      const auto& point = patch.mesh.points[k];
      if (std::abs(point.z()) < 1e-3F) {
        EXPECT_EQ(patch.tools[k], 0) << "the underside is the blank's";
      }
      const bool is_within = point.y() > 1.0F && point.y() < 19.0F;
      const bool is_floor =
          std::abs(point.z() - 6.0F) < 1e-3F || std::abs(point.z() - 3.0F) < 1e-3F;
      if (!is_within || !is_floor || std::abs(std::remainder(point.x() - 10.0F, 20.0F)) > 1.0F)
        continue;
      EXPECT_EQ(patch.tools[k], point.x() < 20.0F ? 7 : 31) << point.transpose();
      ++floors;
    }
  }
  EXPECT_GT(floors, 100U);
}

// What is drawn again where a brick has changed is the surface of now, everywhere.
TEST(CutMarks, TellEveryBrickThatHasChanged) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3.0, 43.0);
  std::normal_distribution<double> normal;
  Workpiece workpiece = marked_plate(40.0, 40.0, 40.0, 0.6);
  const MillingTool tool = workpiece.milling_tool(testing::rotating(ToolKind::ball, 2.5));
  auto shown = patches_of(workpiece);
  std::size_t untouched = 0;
  for (int cut = 0; cut < 40; ++cut) {
    const std::uint32_t known = workpiece.marks()->close_version();
    const Vector axis = Vector(normal(random), normal(random), normal(random)).normalized();
    const Vector at(place(random), place(random), place(random));
    workpiece.mill(tool, {at, axis}, {at + 4.0 * axis, axis}, testing::at_feed(1));
    for (std::size_t brick = 0; brick < shown.size(); ++brick) {
      if (workpiece.marks()->changed(brick) <= known) {
        ++untouched;
        continue;
      }
      shown[brick] = patch_of(workpiece.material(), workpiece.marks()->cubes_of(brick));
    }
    const Mesh whole = surface_of(workpiece.material());
    ASSERT_EQ(triangles_of(shown), whole.triangles.size()) << cut;
    ASSERT_NEAR(volume_of(shown), whole.volume(), 1e-2) << cut;
  }
  EXPECT_GT(untouched, 20 * shown.size()) << "most bricks are left alone by most cuts";
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
