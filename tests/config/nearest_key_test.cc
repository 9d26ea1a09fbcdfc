// The remedy for a typing error.
#include "config/nearest_key.h"

#include <gtest/gtest.h>

#include <array>

namespace stanok::config {
namespace {

TEST(TypingDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(typing_distance("kmv", "kmv"), 0);
  EXPECT_EQ(typing_distance("kmv", "kv"), 1);
  EXPECT_EQ(typing_distance("kv", "kmv"), 1);
  EXPECT_EQ(typing_distance("jark", "jerk"), 1);
  EXPECT_EQ(typing_distance("jrek", "jerk"), 1);
  EXPECT_EQ(typing_distance("", "jerk"), 4);
  EXPECT_EQ(typing_distance("kitten", "sitting"), 3);
}

constexpr std::array<std::string_view, 4> known{"min", "max", "velocity_max", "jerk_max"};

TEST(NearestKey, IsTheOneMostLikelyMeant) {
  EXPECT_EQ(nearest_key("velocitymax", known), "velocity_max");
  EXPECT_EQ(nearest_key("jerkmax", known), "jerk_max");
  EXPECT_EQ(nearest_key("mx", known), "max");
}

TEST(NearestKey, IsNothingWhenTooMuchWouldHaveToChange) {
  EXPECT_EQ(nearest_key("colour", known), "");
  EXPECT_EQ(nearest_key("x", known), "");
}

}  // namespace
}  // namespace stanok::config
