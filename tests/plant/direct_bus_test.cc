// The simulated drives on the virtual clock: same behaviour as over Modbus, the same bits each run.
#include "plant/direct_bus.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "tests/support/no_allocation.h"

namespace stanok::plant {
namespace {

using drives::DriveState;

drives::BusConfig config() {
  drives::BusConfig bus;
  bus.axes = {{.axis = "X", .unit = 1}, {.axis = "Y", .unit = 2}};
  return bus;
}

class DirectBusTest : public ::testing::Test {
 protected:
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      bus.write(targets);
      bus.read(feedback);
    }
  }
  void switch_on() {
    targets.fill({.enabled = true, .brake_closed = false});
    run(50);
    ASSERT_EQ(feedback[0].state, DriveState::operation_enabled);
  }

  DirectBus bus{config(), drives_of(config(), {}), 1.0 * millisecond};
  std::array<drives::DriveTarget, 2> targets{};
  std::array<drives::DriveFeedback, 2> feedback{};
};

TEST_F(DirectBusTest, FirstCycleHasFeedback) {
  run(1);
  EXPECT_TRUE(feedback[0].valid);
  EXPECT_TRUE(feedback[1].valid);
}

TEST_F(DirectBusTest, FeedbackGrowsOldBetweenPolls) {
  run(1);
  EXPECT_EQ(feedback[0].age_cycles, 0U);
  run(9);
  EXPECT_EQ(feedback[0].age_cycles, 9U);
  run(1);
  EXPECT_EQ(feedback[0].age_cycles, 0U);
}

TEST_F(DirectBusTest, FollowsAMoveWithinTheLimitOfTheFollowingError) {
  switch_on();
  const double amplitude = 10.0;
  const double w = 2.0 * 3.14159265358979 * 1.0;  // 1 Hz: 63 mm/s, 395 mm/s2
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 1e-3;
    targets[0].position = amplitude * (1.0 - std::cos(w * t));
    targets[0].velocity = amplitude * w * std::sin(w * t);
    run(1);
    ASSERT_LT(std::fabs(feedback[0].following_error), 0.1) << i;
  }
  EXPECT_FALSE(feedback[0].following_error_exceeded);
  EXPECT_EQ(feedback[0].state, DriveState::operation_enabled);
}

TEST_F(DirectBusTest, ASilentDriveIsInvalidAfterTheTimeout) {
  switch_on();
  bus.inject(0, FaultKind::off);
  run(240);
  EXPECT_TRUE(feedback[0].valid);
  run(30);
  EXPECT_FALSE(feedback[0].valid);
  EXPECT_TRUE(feedback[1].valid);
  EXPECT_GT(bus.status().errors[static_cast<std::size_t>(drives::ExchangeError::timeout)], 20U);
}

TEST(DirectBus, GivesTheSameBitsEveryRun) {
  const auto trace = [] {
    DirectBus bus(config(), drives_of(config(), {}), 1.0 * millisecond);
    bus.inject(1, FaultKind::intermittent);
    std::array<drives::DriveTarget, 2> targets{};
    std::array<drives::DriveFeedback, 2> feedback{};
    targets.fill({.enabled = true, .brake_closed = false});
    std::vector<std::uint64_t> bits;
    for (int i = 0; i < 2000; ++i) {
      targets[0].position = targets[1].position = std::sin(i * 1e-3);
      bus.write(targets);
      bus.read(feedback);
      for (const auto& f : feedback) {
        bits.push_back(std::bit_cast<std::uint64_t>(f.position));
        bits.push_back(f.sequence);
      }
    }
    return bits;
  };
  EXPECT_EQ(trace(), trace());
}

TEST_F(DirectBusTest, AllocatesNothing) {
  const testing::NoAllocation guard;
  run(20);
}

}  // namespace
}  // namespace stanok::plant
