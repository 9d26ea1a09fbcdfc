// What a tap asks of its spindle, by itself.
#include "motion/threads/tap_reversal.h"

#include <gtest/gtest.h>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using Kind = SpindleOrder::Kind;
using stanok::testing::cycle_s;

constexpr double speed_in = 10.0;  // turns/s
constexpr SpindleMotion turning{.speed = speed_in, .speed_wanted = speed_in};
constexpr SpindleMotion standing{};
constexpr PathMotion moving{.v = speed_in};

SpindleCoupling tap() {
  SpindleCoupling coupling;
  coupling.kind = SpindleCoupling::Kind::tap;
  coupling.spindle = 1;
  coupling.bottom = 8.0;
  coupling.spindle_acceleration = 100.0;
  coupling.return_speed_factor = 2.0;
  coupling.dwell_s = 0.1;
  return coupling;
}

TapReversal in_the_hole(const SpindleCoupling& coupling) {
  TapReversal reversal(cycle_s);
  reversal.begin(coupling);
  return reversal;
}

// v^2 / 2a = 0.5 turns are needed; the spindle is told so a little earlier, and once.
TEST(TapReversal, StopsTheSpindleForTheBottom) {
  TapReversal reversal = in_the_hole(tap());
  EXPECT_EQ(reversal.advance(turning, 7.40, moving).kind, Kind::none);
  const SpindleOrder order = reversal.advance(turning, 7.49, moving);
  EXPECT_EQ(order.kind, Kind::stop_within);
  EXPECT_EQ(order.spindle, 1);
  // From where the spindle is now: it is at 7.49 at the end of the cycle.
  EXPECT_NEAR(order.turns, 0.51 + speed_in * cycle_s, 1e-12);
  EXPECT_EQ(reversal.advance(turning, 7.50, moving).kind, Kind::none);
}

// It stands in its hole when its chain begins: out at its own speed at once, then stopped.
TEST(TapReversal, TurnsOutFromWhereItWasStopped) {
  SpindleCoupling out = tap();
  out.kind = SpindleCoupling::Kind::tap_out;
  out.dwell_s = 0.0;
  out.out_speed = -7.0;
  TapReversal reversal = in_the_hole(out);
  EXPECT_TRUE(reversal.is_tap());
  const SpindleOrder order = reversal.advance(standing, 8.0, {});
  EXPECT_EQ(order.kind, Kind::turn_out);
  EXPECT_EQ(order.spindle, 1);
  EXPECT_EQ(order.speed, -7.0);
  EXPECT_EQ(order.acceleration, 100.0);
  EXPECT_TRUE(reversal.returns());
  EXPECT_EQ(reversal.advance(turning, 7.0, moving).kind, Kind::none);
  EXPECT_EQ(reversal.go_on().kind, Kind::stop);
}

TEST(TapReversal, TurnsBackWhenSpindleAndPathHaveStoodForTheDwell) {
  TapReversal reversal = in_the_hole(tap());
  (void)reversal.advance(turning, 7.9, moving);
  for (int n = 0; n < 50; ++n) {
    ASSERT_EQ(reversal.advance(standing, 8.0, moving).kind, Kind::none) << "the path moves";
  }
  SpindleOrder order;
  int cycles = 0;
  while (order.kind == Kind::none && cycles < 1000) {
    ASSERT_FALSE(reversal.returns());
    order = reversal.advance(standing, 8.0, {});
    ++cycles;
  }
  EXPECT_EQ(order.kind, Kind::turn_back);
  EXPECT_EQ(order.factor, 2.0);
  EXPECT_EQ(order.acceleration, 100.0);
  // The first cycle sees that both stand, the last one gives the order.
  EXPECT_EQ(cycles, 1 + 100 + 1);
  EXPECT_TRUE(reversal.returns());
  EXPECT_EQ(reversal.advance(standing, 8.0, {}).kind, Kind::none);
  EXPECT_EQ(reversal.go_on().kind, Kind::go_on);
}

TEST(TapReversal, StopsAtOnceWithAllThatTheSpindleHas) {
  const SpindleOrder order = in_the_hole(tap()).stop_at_once(turning);
  EXPECT_EQ(order.kind, Kind::stop_within);
  EXPECT_DOUBLE_EQ(order.turns, 0.5);
}

TEST(TapReversal, NothingIsAskedOfTheSpindleOfAThread) {
  SpindleCoupling coupling = tap();
  coupling.kind = SpindleCoupling::Kind::thread;
  TapReversal reversal = in_the_hole(coupling);
  EXPECT_FALSE(reversal.is_tap());
  EXPECT_EQ(reversal.advance(turning, 100.0, moving).kind, Kind::none);
}

}  // namespace
}  // namespace stanok::motion
