// What axes allow along an arc, by its closed form.
#include "motion/time_optimum/limit_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/bounds/segment_bounds.h"
#include "tests/motion/path_samples.h"

namespace stanok::motion::testing {
namespace {

constexpr Limits grid_limits{.v = 500.0, .a = 2000.0, .j = 50000.0};
constexpr double grid_radius = 12.0;

Segment quarter_of_a_circle() {
  ChainMaker chain(grid_limits);
  chain.arc(grid_radius, 1.5, 100.0);
  return chain.built().front().segment;
}

// x = r cos(s/r) - r, y = r sin(s/r).
TEST(LimitGrid, HoldsTheDerivativesOfEachAxisOverItsLimits) {
  LimitGrid grid(three_axes(grid_limits));
  const std::vector<double> knots{0.0, 2.0, 5.0, 1.5 * grid_radius};
  grid.add(quarter_of_a_circle(), knots);
  grid.finish();
  ASSERT_EQ(grid.size(), 3U);
  ASSERT_EQ(grid.axes(), 2U);  // Z does not move
  for (std::size_t m = 0; m < grid.size(); ++m) {
    EXPECT_DOUBLE_EQ(grid.length(m), knots[m + 1] - knots[m]);
    const std::array<double, LimitGrid::places> parts{0.0, 0.5, 1.0, 0.25, 0.75};
    for (std::size_t place = 0; place < parts.size(); ++place) {
      const double w = (knots[m] + parts[place] * grid.length(m)) / grid_radius;
      const auto rates = grid.rates(m, static_cast<LimitGrid::Place>(place));
      const double r2 = grid_radius * grid_radius;
      EXPECT_NEAR(rates[0].velocity, -std::sin(w) / grid_limits.v, 1e-12);
      EXPECT_NEAR(rates[0].tangent, -std::sin(w) / grid_limits.a, 1e-12);
      EXPECT_NEAR(rates[0].curvature, -std::cos(w) / grid_radius / grid_limits.a, 1e-12);
      EXPECT_NEAR(rates[0].aberrancy, std::sin(w) / r2 / grid_limits.j, 1e-12);
      EXPECT_NEAR(rates[1].thrust, std::cos(w) / grid_limits.j, 1e-12);
      EXPECT_NEAR(rates[1].bend, -std::sin(w) / grid_radius / grid_limits.j, 1e-12);
      EXPECT_NEAR(rates[1].aberrancy, -std::cos(w) / r2 / grid_limits.j, 1e-12);
    }
  }
}

TEST(LimitGrid, TheFeedIsTheHighestSpeedWhereAxesAllowMore) {
  LimitGrid grid(three_axes(grid_limits));
  grid.add(quarter_of_a_circle(), std::vector<double>{0.0, 1.0});
  grid.finish();
  EXPECT_DOUBLE_EQ(grid.top(0), 100.0 * 100.0);
}

TEST(LimitGrid, TellsWhatLongIntervalsMiss) {
  LimitGrid grid(three_axes(grid_limits));
  grid.add(quarter_of_a_circle(), std::vector<double>{0.0, 1.5 * grid_radius});
  const double rough = grid.largest_miss(0);
  grid.cut(0);
  EXPECT_EQ(grid.size(), 0U);
  grid.add(quarter_of_a_circle(), std::vector<double>{0.0, 0.5 * grid_radius, grid_radius});
  const double fine = grid.largest_miss(0);
  // The polynomial of fourth degree misses by the fifth power of the interval.
  EXPECT_LT(fine, rough / 100.0);
  const double peak = 1.0 / (grid_radius * grid_radius * grid_limits.j);
  EXPECT_NEAR(grid.largest_aberrancy(0), peak, 1e-9 * peak);
}

}  // namespace
}  // namespace stanok::motion::testing
