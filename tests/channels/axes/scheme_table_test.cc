// Schemes of a channel and what they say of its axes.
#include "channels/axes/scheme_table.h"

#include <gtest/gtest.h>

#include "tests/support/machine/channel_bench.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

constexpr lang::AxisSet x_alone = 1U << bench_x;
constexpr lang::AxisSet x_and_y = 1U << bench_x | 1U << bench_y;

TEST(SchemeTableTest, KnowsTheActiveSchemeAndTheOthers) {
  const BenchSchemes schemes = bench_schemes();
  SchemeTable table(schemes, 0);
  EXPECT_EQ(table.active(), schemes.at(0).get());
  EXPECT_EQ(table.find(7), nullptr);
  table.select(1);
  EXPECT_EQ(table.active_id(), 1);
  EXPECT_EQ(table.active(), schemes.at(1).get());
}

TEST(SchemeTableTest, TellsWhichAxesTakePartAndWhichAreParked) {
  const BenchSchemes schemes = bench_schemes();
  SchemeTable table(schemes, 0);
  EXPECT_EQ(table.participants(), x_and_y);
  EXPECT_FALSE(table.parks(bench_y));
  EXPECT_EQ(table.axes_of(1), x_and_y);  // with the one that it parks
  EXPECT_EQ(table.axes_of(7), 0);
  table.select(1);
  EXPECT_EQ(table.participants(), x_alone);
  EXPECT_TRUE(table.parks(bench_y));
}

}  // namespace
}  // namespace stanok::channels
