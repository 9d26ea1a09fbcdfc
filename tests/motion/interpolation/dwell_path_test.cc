// The equivalent dwell path by itself: its length over the feed is a time.
#include "motion/interpolation/dwell_path.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

DwellPath two_mm(const StandFeed& feed) {
  DwellPath dwell;
  EXPECT_FALSE(dwell.is_on());
  dwell.begin(2.0, feed);
  EXPECT_TRUE(dwell.is_on());
  return dwell;
}

TEST(DwellPath, LastsAsLongAsItsLengthTakesAtTheFeed) {
  DwellPath dwell = two_mm({.per_s = 10.0});
  EXPECT_EQ(dwell.advance({}, 0.125), 0.0);
  EXPECT_TRUE(dwell.is_on());
  EXPECT_NEAR(dwell.advance({}, 0.125), 0.05, 1e-12);  // 2 mm at 10 mm/s are 0.2 s
  EXPECT_FALSE(dwell.is_on());
}

TEST(DwellPath, AHoldStopsItAndAnOverrideStretchesIt) {
  DwellPath dwell = two_mm({.per_s = 10.0});
  EXPECT_EQ(dwell.advance({.hold = true}, 10.0), 0.0);
  EXPECT_NEAR(dwell.advance({.feed_override = 0.5}, 0.5), 0.1, 1e-12);
}

// Of a feed per revolution.
TEST(DwellPath, ASpindleThatTurnsTwiceAsFastHalvesIt) {
  DwellPath dwell = two_mm({.per_s = 10.0, .rev_per_min = 100.0});
  const FeedControl control{.spindle_rev_per_min = 200.0};
  EXPECT_EQ(dwell.feed_commanded(control), 20.0);
  EXPECT_NEAR(dwell.advance(control, 0.5), 0.4, 1e-12);
  EXPECT_EQ(dwell.feed_commanded(control), 0.0);
}

TEST(DwellPath, ADroppedOneIsOver) {
  DwellPath dwell = two_mm({.per_s = 10.0});
  dwell.drop();
  EXPECT_FALSE(dwell.is_on());
}

}  // namespace
}  // namespace stanok::motion
