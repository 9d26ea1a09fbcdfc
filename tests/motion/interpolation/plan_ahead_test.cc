// What the cycle sees of the committed plan before it changes its pace.
#include "motion/interpolation/plan_ahead.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

constexpr double v = 10.0;
constexpr double cycle = 0.001;

// 10 mm at an even speed over two segments, the second of which is bent more, and a phase that uses
// most of its limits.
class PaceRoomTest : public ::testing::Test {
 protected:
  void SetUp() override {
    push_segment(1e-5);
    push_segment(1e-3);
    push_segment(1e-5);
    ASSERT_TRUE(queue_.phases.push({.duration = 1.0, .v = v, .s_end = 10.0, .v_end = v}));
    ASSERT_TRUE(queue_.phases.push({.duration = 0.5,
                                    .s = 10.0,
                                    .v = v,
                                    .s_end = 15.0,
                                    .v_end = v,
                                    .pace = {.use = 0.9F, .velocity = 0.01F, .thrust = 0.01F}}));
    ASSERT_TRUE(queue_.chunks.push({.segments = 3, .phases = 2, .last = true, .length = 15.0}));
    cursor_.enter(queue_);
  }
  void push_segment(double bend) {
    Segment segment;
    segment.length = 5.0;
    segment.bounds = {.tangent = 1.0 / 2500.0, .thrust = 1.0 / 50000.0, .bend = bend};
    ASSERT_TRUE(queue_.segments.push(segment));
  }
  // At a place of the even phase.
  PaceRoom room_at(double s) {
    cursor_.go_to(queue_, s);
    return pace_room(queue_, cursor_, s, s / v, cycle);
  }

  PathQueue queue_{16};
  PathCursor cursor_;
};

// P = v / a, Q = v / j, R = v^2 bend of the one segment that the next 10 ms touch.
TEST_F(PaceRoomTest, OfASegmentFollowsFromItsBounds) {
  const PaceRoom room = room_at(4.8);
  EXPECT_FLOAT_EQ(room.here.velocity, 10.0F / 2500.0F);
  EXPECT_FLOAT_EQ(room.here.thrust, 10.0F / 50000.0F);
  EXPECT_FLOAT_EQ(room.here.coupling, 1e-3F);
  EXPECT_EQ(room.here.use, 0.0F);
  EXPECT_EQ(room.ahead.coupling, room.here.coupling);
}

TEST_F(PaceRoomTest, SeesASegmentThatIsBentMoreBeforeItComes) {
  const PaceRoom room = room_at(4.95);
  EXPECT_FLOAT_EQ(room.here.coupling, 1e-3F);
  EXPECT_FLOAT_EQ(room.ahead.coupling, 0.1F);
}

TEST_F(PaceRoomTest, CountsASegmentThatACycleEntersAsHere) {
  EXPECT_FLOAT_EQ(room_at(4.995).here.coupling, 0.1F);
}

TEST_F(PaceRoomTest, SeesThePhaseThatFollowsALongOne) {
  const PaceRoom room = room_at(9.95);
  EXPECT_EQ(room.ahead.use, 0.9F);
  EXPECT_EQ(room.ahead.thrust, 0.01F);
  EXPECT_EQ(room.here.use, 0.0F);
}

}  // namespace
}  // namespace stanok::motion
