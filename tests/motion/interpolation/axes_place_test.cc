// Where the axes are and where they stand, by itself.
#include "motion/interpolation/axes_place.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

Segment line_to_ten() {
  Segment segment;
  segment.tag = {.run = 1, .block = 7, .line = 3, .file = 0};
  segment.length = 10.0;
  segment.geometry.end = {10.0};
  segment.process.rev_per_min = 100.0;
  return segment;
}

TEST(AxesPlace, StandsWhereItIsToldTo) {
  AxesPlace place;
  place.stand_at({1.0, 2.0, 3.0}, {});
  JetPoint point{};
  JetPoint axes{};
  place.standing(point, axes);
  EXPECT_EQ(axes[1].value, 2.0);
  EXPECT_EQ(point[2].value, 3.0);
}

TEST(AxesPlace, StandsAtRestWhereThePathEnded) {
  AxesPlace place;
  place.stand_on(line_to_ten(), 4.0);
  JetPoint point{};
  JetPoint axes{};
  place.standing(point, axes);
  EXPECT_EQ(point[0].value, 4.0);
  EXPECT_EQ(axes[0].value, 4.0);
  EXPECT_EQ(axes[0].first, 0.0);
  EXPECT_EQ(place.tag().block, 7U);
  EXPECT_EQ(place.process().rev_per_min, 100.0);
}

TEST(AxesPlace, AxesWithoutATransformAreThePoint) {
  AxesPlace place;
  JetPoint point{};
  point[0] = {5.0, 20.0, 1.0, 2.0};
  JetPoint axes{};
  place.follow(line_to_ten(), point, axes);
  EXPECT_EQ(axes[0].value, 5.0);
  EXPECT_EQ(axes[0].third, 2.0);
}

}  // namespace
}  // namespace stanok::motion
