// The way back is the way that the axes came, part by part.
#include "channels/axes/way_aside.h"

#include <gtest/gtest.h>

#include <vector>

namespace stanok::channels {
namespace {

motion::Point place_of(double x, double y, double z) {
  motion::Point point{};
  point[0] = x;
  point[1] = y;
  point[2] = z;
  return point;
}

class WayAsideTest : public ::testing::Test {
 protected:
  WayAsideTest() { way.begin(place_of(1.0, 2.0, 3.0)); }

  void go(const motion::Point& to) {
    motion::JetPoint axes{};
    for (std::size_t k = 0; k < to.size(); ++k) axes[k] = kinematics::Jet(to[k]);
    way.follow(axes);
    way.come_to_rest();
  }
  // Places at which the axes rest on their way back.
  std::vector<motion::Point> back() {
    std::vector<motion::Point> rests;
    while (!way.is_at_path()) {
      rests.push_back(way.turn_back());
      go(motion::Point(rests.back()));
    }
    return rests;
  }

  WayAside way;
};

TEST_F(WayAsideTest, BeginsOnThePath) {
  EXPECT_TRUE(way.is_on());
  EXPECT_TRUE(way.is_at_path());
  way.end();
  EXPECT_FALSE(way.is_on());
}

TEST_F(WayAsideTest, GoesBackAsItCame) {
  go(place_of(1.0, 2.0, 8.0));
  go(place_of(4.0, 2.0, 8.0));
  go(place_of(4.0, 9.0, 8.0));
  EXPECT_EQ(back(), (std::vector{place_of(4.0, 2.0, 8.0), place_of(1.0, 2.0, 8.0),
                                 place_of(1.0, 2.0, 3.0)}));
}

// The tool is longer by 2: where its point came, it goes back.
TEST_F(WayAsideTest, MovesAlongWithTheLengthOfTheTool) {
  motion::MotionConfig config;
  config.axes[2].position_max = 9.5;
  go(place_of(1.0, 2.0, 7.0));
  go(place_of(4.0, 2.0, 7.0));
  go(place_of(4.0, 2.0, 9.0));
  way.shift(place_of(1.0, 2.0, 5.0), config);
  EXPECT_EQ(back(), (std::vector{place_of(4.0, 2.0, 9.5), place_of(4.0, 2.0, 9.0),
                                 place_of(1.0, 2.0, 9.0), place_of(1.0, 2.0, 5.0)}));
}

TEST_F(WayAsideTest, OnThePathLeadsToWhereThePathIsThen) {
  way.shift(place_of(1.0, 2.0, 5.0), {});
  EXPECT_FALSE(way.is_at_path());
  EXPECT_EQ(back(), std::vector{place_of(1.0, 2.0, 5.0)});
}

// Ten clicks upwards and two down again are one part.
TEST_F(WayAsideTest, MovesAlongOneAxisAreOnePart) {
  for (int n = 1; n <= 10; ++n) go(place_of(1.0, 2.0, 3.0 + n));
  for (int n = 9; n >= 8; --n) go(place_of(1.0, 2.0, 3.0 + n));
  EXPECT_EQ(back(), std::vector{place_of(1.0, 2.0, 3.0)});
}

TEST_F(WayAsideTest, WhatWasStoppedOnTheWayBackGoesOnFromThere) {
  go(place_of(1.0, 2.0, 8.0));
  go(place_of(4.0, 9.0, 8.0));
  EXPECT_EQ(way.turn_back(), place_of(1.0, 2.0, 8.0));
  go(place_of(2.5, 5.5, 8.0));
  EXPECT_EQ(back(), (std::vector{place_of(1.0, 2.0, 8.0), place_of(1.0, 2.0, 3.0)}));
}

TEST_F(WayAsideTest, AfterAStopAnotherWayMayBeTaken) {
  go(place_of(1.0, 2.0, 8.0));
  static_cast<void>(way.turn_back());
  go(place_of(1.0, 2.0, 5.0));
  go(place_of(6.0, 2.0, 5.0));
  EXPECT_EQ(back(), (std::vector{place_of(1.0, 2.0, 5.0), place_of(1.0, 2.0, 3.0)}));
}

TEST_F(WayAsideTest, HasRoomForSixtyThreeParts) {
  for (int n = 1; !way.is_full(); ++n) {
    ASSERT_LT(n, 64);
    go(place_of(1.0 + n, 2.0, 3.0 + (n % 2)));
  }
  EXPECT_EQ(back().size(), 63U);
}

}  // namespace
}  // namespace stanok::channels
