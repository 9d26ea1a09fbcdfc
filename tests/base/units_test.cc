#include "base/units.h"

#include <gtest/gtest.h>

#include <numbers>
#include <type_traits>

namespace stanok {
namespace {

TEST(Units, AFeedPerMinuteIsReadPerSecond) {
  const Speed feed = 300.0 * mm / minute;
  EXPECT_DOUBLE_EQ(feed / (mm / second), 5.0);
  EXPECT_DOUBLE_EQ(feed / (mm / minute), 300.0);
}

TEST(Units, AnInchIsExactly25Point4Millimetres) {
  EXPECT_EQ((1.0 * inch) / mm, 25.4);
}

TEST(Units, AnglesAreHeldInDegreesToTheBit) {
  EXPECT_EQ((33.3 * degree) / degree, 33.3);
  EXPECT_EQ((1.0 * turn) / degree, 360.0);
  EXPECT_DOUBLE_EQ((std::numbers::pi * radian) / degree, 180.0);
}

TEST(Units, ProductsAndQuotientsCarryTheirDimension) {
  static_assert(std::is_same_v<decltype(mm / second), Speed>);
  static_assert(std::is_same_v<decltype(mm / second / second), Acceleration>);
  static_assert(std::is_same_v<decltype(mm / second / second / second), Jerk>);
  static_assert(std::is_same_v<decltype((mm / second) * second), Distance>);
  static_assert(std::is_same_v<decltype(degree / second), AngularSpeed>);
  static_assert(std::is_same_v<decltype(mm / inch), double>);
  // Stopping distance of constant deceleration: v^2 / 2a.
  const Speed v = 100.0 * mm / second;
  const Acceleration a = 500.0 * mm / second / second;
  EXPECT_DOUBLE_EQ((v * v / a * 0.5) / mm, 10.0);
}

TEST(Units, QuantitiesOfOneKindCompareAndAdd) {
  EXPECT_LT(25.0 * mm, 1.0 * inch);
  EXPECT_EQ(60.0 * second, 1.0 * minute);
  EXPECT_DOUBLE_EQ((1.0 * second + 500.0 * millisecond - 2.0 * second) / millisecond, -500.0);
  EXPECT_DOUBLE_EQ(-(2.0 * mm) / mm, -2.0);
}

TEST(Units, EverythingIsKnownToTheCompiler) {
  static_assert((120.0 * mm / minute) / (mm / second) == 2.0);
  static_assert(Distance{} == 0.0 * mm);
}

}  // namespace
}  // namespace stanok
