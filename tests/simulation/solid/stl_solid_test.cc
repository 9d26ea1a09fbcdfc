// Blanks from STL files: what is read, what is refused and why, and the material of their rays
// against formulas.
#include "simulation/solid/stl_solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "simulation/material.h"
#include "simulation/surface_mesh.h"
#include "tests/support/stl_text.h"

namespace stanok::simulation {
namespace {

using ::testing::HasSubstr;
using namespace stanok::testing;

Blank blank_of(const StlTriangles& triangles, double resolution, double scale = 1.0) {
  auto solid = solid_of_stl(binary_stl(triangles));
  EXPECT_TRUE(solid);
  Blank blank;
  blank.kind = BlankKind::solid;
  blank.solid = std::make_shared<const Solid>(std::move(*solid));
  blank.scale = scale;
  blank.resolution = resolution;
  blank.size = scale * (blank.solid->high - blank.solid->low);
  return blank;
}

std::string refusal(const std::string& bytes) {
  const auto solid = solid_of_stl(bytes);
  return solid ? "taken" : solid.error().code + " " + solid.error().text;
}

TEST(StlSolid, ReadsABoxInBothForms) {
  const StlTriangles box = stl_box({-10.0, 5.0, -2.0}, {30.0, 25.0, 10.0});
  for (const std::string& bytes : {ascii_stl(box), binary_stl(box)}) {
    const auto solid = solid_of_stl(bytes);
    ASSERT_TRUE(solid) << solid.error().text;
    EXPECT_EQ(solid->triangles.size(), 12U);
    EXPECT_EQ(solid->low, Vector(-10.0, 5.0, -2.0));
    EXPECT_EQ(solid->high, Vector(30.0, 25.0, 10.0));
    EXPECT_NEAR(solid->volume, 40.0 * 20.0 * 12.0, 1e-9);
  }
}

TEST(StlSolid, ReadsCapitalsPlusSignsAndSeveralSolidsInOneFile) {
  const std::string lower = ascii_stl(stl_box({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}));
  std::string capitals = lower;
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  EXPECT_EQ(refusal(capitals), "taken");
  std::string plus = lower;
  for (std::size_t at = 0; (at = plus.find("vertex 1", at)) != std::string::npos; ++at)
    plus.insert(at + 7, "+");
  EXPECT_EQ(refusal(plus), "taken");
  const auto two = solid_of_stl(lower + ascii_stl(stl_box({5.0, 0.0, 0.0}, {7.0, 1.0, 1.0})));
  ASSERT_TRUE(two);
  EXPECT_NEAR(two->volume, 3.0, 1e-9);
}

TEST(StlSolid, RefusesWhatIsNoStlFileOrDamaged) {
  const StlTriangles box = stl_box({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  const std::string binary = binary_stl(box);
  EXPECT_THAT(refusal(""), HasSubstr("E7020 0 bytes are no STL file"));
  EXPECT_THAT(refusal("G0 X1\nM30\n"), HasSubstr("E7020"));
  EXPECT_THAT(refusal(binary.substr(0, binary.size() - 1)),
              HasSubstr("E7020 a binary STL file of 12 triangles has 684 bytes, this one has 683"));
  std::string text = ascii_stl(box);
  text.replace(text.find("vertex 1"), 8, "vertex x");
  EXPECT_THAT(refusal(text), HasSubstr("E7020 line "));
  EXPECT_THAT(refusal("solid empty\nendsolid empty\n"), HasSubstr("E7020 the file has no tri"));
  std::string no_number = binary;
  no_number.replace(84 + 12, 4, "\xFF\xFF\xFF\x7F");
  EXPECT_THAT(refusal(no_number), HasSubstr("E7020 a corner of triangle 1 is no number"));
  EXPECT_THAT(refusal(ascii_stl(box).substr(0, 200)), HasSubstr("E7020 line "));
}

TEST(StlSolid, RefusesASurfaceThatIsNotClosed) {
  StlTriangles open = stl_box({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0});
  open.pop_back();
  EXPECT_THAT(refusal(ascii_stl(open)), HasSubstr("E7021 the surface is not closed: 3 edges"));
  // One triangle turned over.
  StlTriangles turned = stl_box({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0});
  std::swap(turned[4][0], turned[4][1]);
  EXPECT_THAT(refusal(ascii_stl(turned)), HasSubstr("E7021"));
  // A corner that is off by the last bit of a float.
  StlTriangles off = stl_box({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0});
  off[0][2][2] = std::nextafter(3.0F, 4.0F);
  EXPECT_THAT(refusal(binary_stl(off)), HasSubstr("E7021"));
}

TEST(StlSolid, RefusesWhatEnclosesNothing) {
  const StlTriangles box = stl_box({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0});
  EXPECT_THAT(refusal(ascii_stl(inside_out(box))), HasSubstr("E7022 the surface is inside out"));
  StlTriangles sheet{{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
  append(sheet, inside_out(sheet));
  EXPECT_THAT(refusal(ascii_stl(sheet)), HasSubstr("E7022 the surface encloses no volume"));
}

TEST(StlSolid, RefusesWhatIsTooLarge) {
  std::string many = binary_stl({});
  const std::uint32_t count = stl_triangles_max + 1;
  std::memcpy(many.data() + 80, &count, sizeof count);
  many.resize(84 + 50UL * count);
  EXPECT_THAT(refusal(many), HasSubstr("E7023 the surface has 500001 triangles, at most 500000"));
  // So many sheets over one another that each ray would be in pieces.
  StlTriangles layers;
  for (int k = 0; k < 40; ++k)
    append(layers, stl_box({0.0, 0.0, 2.0 * k}, {1.0, 1.0, 2.0 * k + 1.0}));
  EXPECT_THAT(refusal(binary_stl(layers)),
              HasSubstr("E7023 the surface lies over itself 80 times"));
}

// Faces of the box are the ends of the grid: exact to the rounding of floats.
TEST(StlSolid, OfABoxFillsTheRaysOfABox) {
  const Blank blank = blank_of(stl_box({-10.0, 5.0, -2.0}, {30.0, 25.0, 10.0}), 0.5);
  const auto grid = grid_of(blank);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->origin, Vector(-10.0, 5.0, -2.0));
  const Material material(blank, *grid);
  EXPECT_NEAR(material.volume(), 9600.0, 1e-2);
  EXPECT_NEAR(volume_of(blank), 9600.0, 1e-9);
}

// In inches: 25.4 mm for a unit.
TEST(StlSolid, TakesItsScale) {
  const Blank blank = blank_of(stl_box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5}), 0.5, 25.4);
  const Material material(blank, *grid_of(blank));
  EXPECT_NEAR(material.volume(), 2.0 * 1.0 * 0.5 * std::pow(25.4, 3.0), 1e-1);
  EXPECT_NEAR(volume_of(blank), std::pow(25.4, 3.0), 1e-6);
}

// The area of a regular polygon; a grid counts a circle right to some parts in ten thousand.
TEST(StlSolid, OfACylinderHasItsVolume) {
  constexpr int corners = 256;
  const Blank blank = blank_of(stl_cylinder(15.0, 0.0, 12.0, corners), 0.05);
  const double wanted = regular_polygon_area(15.0, corners) * 12.0;
  EXPECT_NEAR(blank.solid->volume, wanted, 1e-5 * wanted);
  EXPECT_NEAR(Material(blank, *grid_of(blank)).volume(), wanted, 3e-4 * wanted);
}

TEST(StlSolid, MayBeHollowAndOverlapItself) {
  StlTriangles hollow = stl_box({0.0, 0.0, 0.0}, {20.0, 20.0, 20.0});
  append(hollow, inside_out(stl_box({5.0, 5.0, 5.0}, {15.0, 15.0, 15.0})));
  const Blank box = blank_of(hollow, 0.5);
  EXPECT_NEAR(Material(box, *grid_of(box)).volume(), 8000.0 - 1000.0, 1e-1);
  // Two boxes that share a corner of 5 x 10 x 10: what lies inside of both is material once.
  StlTriangles both = stl_box({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
  append(both, stl_box({5.0, 0.0, 0.0}, {15.0, 10.0, 10.0}));
  const Blank one = blank_of(both, 0.5);
  EXPECT_NEAR(Material(one, *grid_of(one)).volume(), 1500.0, 1e-1);
}

// Whatever way a box lies, every ray that goes in comes out, and the volume stays.
TEST(StlSolid, StaysClosedInEveryDirection) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (int n = 0; n < 20; ++n) {
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vector::UnitZ()) *
                                  Eigen::AngleAxisd(angle(random), Vector::UnitX()))
                                     .toRotationMatrix();
    StlTriangles box = stl_box({0.0, 0.0, 0.0}, {30.0, 20.0, 10.0});
    for (auto& triangle : box) {
      for (StlPoint& point : triangle) {
        const Vector turned = turn * Vector(point.data());
        point = {turned.x(), turned.y(), turned.z()};
      }
    }
    const Blank blank = blank_of(box, 0.2);
    const Material material(blank, *grid_of(blank));
    EXPECT_NEAR(material.volume(), 6000.0, 6.0) << n;
    EXPECT_NEAR(surface_of(material).volume(), 6000.0, 6.0) << n;
  }
}

// Corners that lie on rays: an octahedron whose corners and edges are met by rays to the bit.
TEST(StlSolid, IsWholeWhereRaysMeetItsEdges) {
  const std::array<StlPoint, 6> corners{
      {{8, 0, 0}, {-8, 0, 0}, {0, 8, 0}, {0, -8, 0}, {0, 0, 8}, {0, 0, -8}}};
  StlTriangles all;
  for (const std::size_t x : {0U, 1U}) {
    for (const std::size_t y : {2U, 3U}) {
      for (const std::size_t z : {4U, 5U}) {
        const bool flips = (x + (y - 2) + (z - 4)) % 2 != 0;
        all.push_back({corners[x], corners[flips ? z : y], corners[flips ? y : z]});
      }
    }
  }
  for (const double resolution : {16.0 / 9.0, 16.0 / 33.0, 16.0 / 65.0}) {
    const Blank blank = blank_of(all, resolution);
    const Grid grid = *grid_of(blank);
    const Material material(blank, grid);
    // 4/3 r³; an odd number of rays, of which one runs through the corners.
    EXPECT_EQ(grid.count[0] % 2, 1);
    EXPECT_NEAR(material.volume(), 4.0 / 3.0 * 512.0, 8.0 * resolution * resolution * 8.0);
    EXPECT_GT(material.family(0).overlap(material.ray(0, grid.count[1] / 2, grid.count[2] / 2),
                                         -8.0, 8.0),
              15.9);
  }
}

}  // namespace
}  // namespace stanok::simulation
