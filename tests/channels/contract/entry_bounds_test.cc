// EntryBounds: from the limits of the machine file and the travel of the axes.
#include "channels/contract/entry_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

constexpr int rotation = -2;  // as lang::rotation_of_offset

// Linear axes from -500 to 500, rotary ones without end.
EntryBounds bounds_with(const EntryLimits& limits = {}) {
  MachineConfig machine = testing::two_channel_machine();
  machine.entry_limits = limits;
  return EntryBounds(machine);
}

TEST(EntryBounds, OfAWorkOffsetAreOneToolLengthBeyondTheTravel) {
  const EntryBounds bounds = bounds_with({.tool_length_max_mm = 300.0});
  EXPECT_EQ(bounds.of_offset(0).least, -(500.0 + 300.0));
  EXPECT_EQ(bounds.of_offset(0).most, 500.0 + 300.0);
  EXPECT_TRUE(bounds.of_offset(2).holds(799.0));
  EXPECT_FALSE(bounds.of_offset(2).holds(99999.0));
}

TEST(EntryBounds, OfAWorkOffsetAreThoseOfTheFileWhereItHasThem) {
  EXPECT_EQ(bounds_with({.offset_max_mm = 70.0}).of_offset(1).most, 70.0);
}

TEST(EntryBounds, OfAnglesAreAWholeTurn) {
  for (const int axis : {3, 4, rotation}) {
    const EntryBound bound = bounds_with({.offset_max_mm = 70.0}).of_offset(axis);
    EXPECT_EQ(bound.most, 360.0);
    EXPECT_EQ(bound.least, -360.0);
    EXPECT_EQ(bound.unit, "deg");
  }
}

TEST(EntryBounds, OfToolsAreSignedOrNot) {
  const EntryBounds bounds = bounds_with();
  const struct {
    ToolValue value;
    double least, most;
  } cases[] = {{ToolValue::length, 0.0, 500.0},      {ToolValue::length_x, -500.0, 500.0},
               {ToolValue::length_y, -500.0, 500.0}, {ToolValue::overhang, 0.0, 500.0},
               {ToolValue::wear_length, -2.0, 2.0},  {ToolValue::wear_length_x, -2.0, 2.0},
               {ToolValue::wear_radius, -2.0, 2.0}};
  for (const auto& each : cases) {
    const EntryBound bound = bounds.of_tool(each.value);
    EXPECT_EQ(bound.least, each.least) << name_of(each.value);
    EXPECT_EQ(bound.most, each.most) << name_of(each.value);
  }
  EXPECT_TRUE(bounds.of_tool(ToolValue::radius).holds(250.0));
  EXPECT_FALSE(bounds.of_tool(ToolValue::radius).holds(5000.0));
  EXPECT_TRUE(bounds.of_tool(ToolValue::angle_front).holds(-300.0)) << "its range is fixed";
}

TEST(EntryBounds, HoldNothingThatIsNoNumber) {
  const EntryBound bound = bounds_with().of_offset(0);
  EXPECT_FALSE(bound.holds(std::nan("")));
  EXPECT_FALSE(bound.holds(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(bound.holds(-1e308));
}

TEST(EntryBounds, SayWhichLimitAValueIsBeyond) {
  const EntryBounds bounds = bounds_with();
  const auto reason = [](const EntryBound& bound, double value) {
    return std::string(reason_against(bound, value).view());
  };
  EXPECT_EQ(reason(bounds.of_tool(ToolValue::length), 99999.0),
            "99999 mm is more than 500 mm (tool_length_max)");
  EXPECT_EQ(reason(bounds.of_tool(ToolValue::length), -5.25),
            "-5.25 mm is less than 0 mm (tool_length_min)");
  EXPECT_EQ(reason(bounds.of_tool(ToolValue::wear_radius), -2.005),
            "-2.005 mm is less than -2 mm (wear_max)");
  EXPECT_EQ(reason(bounds.of_change_in_run("deg"), 0.75),
            "0.75 deg is more than 0.5 deg (change_in_run_max)");
  EXPECT_EQ(reason(bounds.of_offset(rotation), 361.0),
            "361 deg is more than 360 deg (a whole turn)");
  EXPECT_EQ(reason(bounds.of_offset(0), -1e308),
            "-more than 1e12 mm is less than -1000 mm (offset_max)");
}

}  // namespace
}  // namespace stanok::channels
