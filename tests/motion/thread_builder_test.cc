// Which threads the axes cannot cut, and what is said of them (motion/thread_builder.h).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/thread_bench.h"

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
  // A hundredth of the speed is kept for the regulator.
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

}  // namespace
}  // namespace stanok::motion::testing
