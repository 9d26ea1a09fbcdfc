// Which threads the axes cannot cut, and what is said of them (motion/threads/thread_builder.h).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/motion/threads/thread_bench.h"

namespace stanok::motion::testing {
namespace {

TEST(ThreadBuilder, NamesTheAxisThatIsTooSlowAndTheHighestSpeed) {
  const MotionConfig config = lathe_axes();
  ThreadBuilder builder(config);
  builder.begin(at(0.0, 0.0), config.geometry, thread_from(0.0), 50.0);
  const auto fault = builder.add(block_to(at(0.0, -20.0), 6.0));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, ThreadFault::Kind::axis_too_slow);
  EXPECT_EQ(fault->axis, static_cast<int>(Z));
  EXPECT_NEAR(fault->value, 300.0, 1e-9);
  // A hundredth of the speed is kept for the controller.
  EXPECT_NEAR(fault->limit, 247.5, 1e-9);
  EXPECT_NEAR(fault->speed_max, 247.5 / 6.0, 1e-9);
}

TEST(ThreadBuilder, RefusesASpeedThatTheRunWouldRefuse) {
  const MotionConfig config = lathe_axes();
  ThreadBuilder builder(config);
  builder.begin(at(0.0, 0.0), config.geometry, thread_from(0.0), 10.0);
  const auto fault = builder.add(block_to(at(0.0, -20.0), 24.8));  // 248 of 250 mm/s
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, ThreadFault::Kind::axis_too_slow);
  EXPECT_FALSE(builder.add(block_to(at(0.0, -20.0), 24.7)));
}

TEST(ThreadBuilder, RefusesACornerThatItsToleranceMakesTooSharp) {
  const MotionConfig config = lathe_axes();
  ThreadBuilder builder(config);
  builder.begin(at(10.0, 0.0), config.geometry, thread_from(0.0), 10.0);
  ThreadBlock straight = block_to(at(10.0, -10.0), 2.0);
  straight.keeps_tolerance = true;
  ASSERT_FALSE(builder.add(straight));
  const auto fault = builder.add(block_to(at(12.0, -12.0), 2.0 * std::sqrt(2.0)));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, ThreadFault::Kind::corner_too_sharp);
  // X gains 2 mm/turn over 2 h turns, 0.01 = 2 h / 6: a = 2 / h * n^2, j = 2 / h^2 * n^3, of which
  // 85 % of 2500 mm/s^2 and of 50000 mm/s^3 may be used, at 1.25 times the speed.
  const double h = 6.0 * 0.01 / 2.0;
  const double by_acceleration = std::sqrt(0.85 * 2500.0 * h / 2.0);
  const double by_jerk = std::cbrt(0.85 * 50000.0 * h * h / 2.0);
  EXPECT_NEAR(fault->speed_max, std::min(by_acceleration, by_jerk) / 1.25, 0.05);
}

// Threads of random leads, lengths and ways out, at any speed that their leads allow: the end is
// the programmed one, Z goes on by the law on every segment, and X leaves the depth no later.
TEST(ThreadBuilder, LetsAWayOutBeginEarlierThanASharpCornerAllows) {
  const MotionConfig config = lathe_axes();
  std::mt19937 random(57);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  int earlier = 0;
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    const double lead = between(0.5, 4.0);
    const double speed = between(2.0, 0.6 * 247.5 / lead);
    const double length = between(15.0, 40.0);
    const double out = between(0.1, 1.5) * lead;
    const double rise = between(0.1, 1.0) * out;
    ThreadBuilder builder(config);
    builder.begin(at(10.0, 0.0), config.geometry, thread_from(0.0), speed);
    ThreadBlock cut = block_to(at(10.0, -length), lead);
    cut.keeps_tolerance = true;
    ASSERT_FALSE(builder.add(cut));
    ThreadBlock way_out =
        block_to(at(10.0 + rise, -length - out), lead * std::hypot(rise, out) / out);
    const bool is_sharp = ThreadBuilder(builder).add(way_out).has_value();
    way_out.runs_out = true;
    const auto fault = builder.add(way_out);
    if (fault) continue;  // too fast for the whole of the thread
    earlier += is_sharp ? 1 : 0;
    const ThreadChain chain = builder.finish();
    double turns = 0.0;
    for (const Segment& segment : chain.segments) {
      EXPECT_NEAR(segment.geometry.start[Z], -lead * turns, 1e-9);
      turns += segment.length;
    }
    EXPECT_NEAR(chain.segments.back().geometry.end[X], 10.0 + rise, 1e-9);
    EXPECT_NEAR(chain.segments.back().geometry.end[Z], -length - out, 1e-9);
    EXPECT_EQ(chain.segments.front().geometry.end[X], 10.0);
    EXPECT_GE(chain.segments.front().geometry.end[Z], -length);
    EXPECT_GE(chain.coupling.speed_max, speed);
  }
  EXPECT_GE(earlier, 100);
}

TEST(ThreadBuilder, LeavesTheChainAsItWasWhereNoEarlierWayOutHelps) {
  const MotionConfig config = lathe_axes();
  ThreadBuilder builder(config);
  builder.begin(at(10.0, 0.0), config.geometry, thread_from(0.0), 60.0);
  ASSERT_FALSE(builder.add(block_to(at(10.0, -0.2), 2.0)));
  ThreadBlock way_out = block_to(at(12.0, -2.2), 2.0 * std::sqrt(2.0));
  way_out.runs_out = true;
  const auto fault = builder.add(way_out);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, ThreadFault::Kind::corner_too_sharp);
  const ThreadChain chain = builder.finish();
  ASSERT_EQ(chain.segments.size(), 1U);
  EXPECT_EQ(chain.segments[0].geometry.end[Z], -0.2);
  EXPECT_EQ(chain.segments[0].length, 0.1);
}

// One whose tolerance is programmed does not grow. Of the jerk J of the axis it takes
// 2 / h^2 (1.25 n)^3, and of the rest the acceleration along the chain at most a half: what is left
// over 2 mm per turn must come to 0.6 of what the encoder needs on a single block.
TEST(ThreadBuilder, RefusesACornerThatLeavesTooLittleJerkForTheEncoder) {
  const MotionConfig config = lathe_axes();
  constexpr double speed = 1.5;
  constexpr double jerk = 50000.0;
  constexpr double needed = 20000.0;
  const auto fault_with = [&](double jerk_to_follow) {
    ThreadBuilder builder(config);
    builder.begin(at(10.0, 0.0), config.geometry, thread_from(0.0), speed, jerk_to_follow);
    ThreadBlock straight = block_to(at(10.0, -10.0), 2.0);
    straight.keeps_tolerance = true;
    EXPECT_FALSE(builder.add(straight));
    return builder.add(block_to(at(12.0, -12.0), 2.0 * std::sqrt(2.0)));
  };
  EXPECT_FALSE(fault_with(0.0));
  const auto fault = fault_with(needed);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, ThreadFault::Kind::corner_too_sharp);
  const double h = 6.0 * 0.01 / 2.0;
  const auto speed_with = [&](double share) {
    return std::cbrt((jerk - 2.0 * 0.6 * needed / share) * h * h / 2.0) / 1.25;
  };
  EXPECT_GE(fault->speed_max, 0.95 * speed_with(0.5));  // bounds have a margin
  EXPECT_LE(fault->speed_max, speed_with(1.0));
}

}  // namespace
}  // namespace stanok::motion::testing
