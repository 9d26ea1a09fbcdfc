// Indices of axes, and arrays that take them.
#include "base/axis_index.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace stanok {
namespace {

static_assert(std::is_trivially_copyable_v<AxisArray<double>>, "it crosses into the cycle");
static_assert(sizeof(AxisArray<double>) == axes_max * sizeof(double));

TEST(AxisIndex, IsNoneUntilItHasANumber) {
  const AxisIndex none;
  EXPECT_FALSE(none.exists());
  EXPECT_EQ(none, AxisIndex(-1));
  EXPECT_EQ(none.bit(), 0U);
  EXPECT_TRUE(AxisIndex(0).exists());
}

TEST(AxisIndex, KeepsItsNumberAsPlaceAndAsBit) {
  for (int number = 0; number < axes_max; ++number) {
    const AxisIndex axis = number;
    EXPECT_EQ(axis.number(), number);
    EXPECT_EQ(axis.place(), static_cast<std::size_t>(number));
    EXPECT_EQ(axis.bit(), 1U << static_cast<unsigned>(number));
  }
}

TEST(AxisArray, HasAValueForEachAxis) {
  AxisArray<double> values{10.0, 20.0};
  EXPECT_EQ(values[AxisIndex(1)], 20.0);
  EXPECT_EQ(values[AxisIndex(7)], 0.0);
  values[AxisIndex(7)] = 33.3;
  EXPECT_EQ(values, (AxisArray<double>{10.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 33.3}));
}

}  // namespace
}  // namespace stanok
