// The remedy for a typing error.
#include "base/nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace stanok {
namespace {

TEST(TypingDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(typing_distance("kmv", "kmv"), 0);
  EXPECT_EQ(typing_distance("kmv", "kv"), 1);
  EXPECT_EQ(typing_distance("kv", "kmv"), 1);
  EXPECT_EQ(typing_distance("jark", "jerk"), 1);
  EXPECT_EQ(typing_distance("jrek", "jerk"), 1);
  EXPECT_EQ(typing_distance("", "jerk"), 4);
  EXPECT_EQ(typing_distance("kitten", "sitting"), 3);
  EXPECT_EQ(typing_distance("WIHLE", "while"), 1);
}

constexpr std::array<std::string_view, 4> known{"min", "max", "velocity_max", "jerk_max"};

TEST(NearestName, IsTheOneMostLikelyMeant) {
  EXPECT_EQ(nearest_name("velocitymax", known), "velocity_max");
  EXPECT_EQ(nearest_name("jerkmax", known), "jerk_max");
  EXPECT_EQ(nearest_name("mx", known), "max");
}

TEST(NearestName, IsNothingWhenTooMuchWouldHaveToChange) {
  EXPECT_EQ(nearest_name("colour", known), "");
  EXPECT_EQ(nearest_name("x", known), "");
  EXPECT_EQ(nearest_name("velocitymax", known, 0), "");
}

}  // namespace
}  // namespace stanok
