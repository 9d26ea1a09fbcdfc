// Blanks: grids that fill them, and those that are none or too fine.
#include "simulation/blank.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <regex>

#include "simulation/material.h"

namespace stanok::simulation {
namespace {

Blank blank(BlankKind kind, const Vector& size, double resolution) {
  Blank blank;
  blank.kind = kind;
  blank.size = size;
  blank.resolution = resolution;
  return blank;
}

TEST(Blank, IsFilledEvenly) {
  const Blank box = blank(BlankKind::box, {10.3, 7.1, 5.0}, 0.5);
  const Grid grid = *grid_of(box);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(grid.cell[k] * grid.count[k], box.size[k], 1e-12);
    EXPECT_NEAR(grid.cell[k], 0.5, 0.05);
  }
  EXPECT_NEAR(Material(box, grid).volume(), 10.3 * 7.1 * 5.0, 1e-3);
}

// The volume of a tube by its formula. What a grid of 0.05 mm counts of a circle of radius 15 is
// right to some parts in ten thousand.
TEST(Blank, MayBeATube) {
  const Blank tube = blank(BlankKind::cylinder, {30.0, 18.0, 12.0}, 0.05);
  EXPECT_NEAR(Material(tube, *grid_of(tube)).volume(), volume_of(tube), 3e-4 * volume_of(tube));
}

TEST(Blank, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Blank& none :
       {blank(BlankKind::box, {0.0, 1.0, 1.0}, 0.5), blank(BlankKind::box, {1.0, -1.0, 1.0}, 0.5),
        blank(BlankKind::box, {1.0, nan, 1.0}, 0.5),
        blank(BlankKind::unknown, {1.0, 1.0, 1.0}, 0.5),
        blank(BlankKind::cylinder, {10.0, 10.0, 5.0}, 0.5),
        blank(BlankKind::cylinder, {10.0, -1.0, 5.0}, 0.5),
        blank(BlankKind::box, {1.0, 1.0, 1.0}, 0.0), blank(BlankKind::box, {1.0, 1.0, 1.0}, -0.1),
        blank(BlankKind::box, {1.0, 1.0, 1.0}, nan)}) {
    const auto grid = grid_of(none);
    ASSERT_FALSE(grid);
    EXPECT_EQ(grid.error().code, "E9202");
  }
}

TEST(Blank, NamesTheResolutionThatFits) {
  Blank fine = blank(BlankKind::box, {500.0, 400.0, 300.0}, 0.01);
  const auto refused = grid_of(fine, std::uint64_t{1} << 30);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "E9203");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(refused.error().text, found,
                                std::regex("a resolution of ([0-9.]+) mm fits")));
  fine.resolution = std::stod(found[1]);
  EXPECT_TRUE(grid_of(fine, std::uint64_t{1} << 30));
  fine.resolution *= 0.9;
  EXPECT_FALSE(grid_of(fine, std::uint64_t{1} << 30));
}

}  // namespace
}  // namespace stanok::simulation
