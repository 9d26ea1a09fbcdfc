// The simulated drives on the virtual clock: same behaviour as over Modbus, the same bits each run.
#include "plant/drive/direct_bus.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "tests/support/no_allocation.h"

namespace stanok::plant {
namespace {

using drives::DriveState;

drives::BusConfig two_axis_bus() {
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

  DirectBus bus{two_axis_bus(), drives_of(two_axis_bus(), {}), 1.0 * millisecond};
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

// On a computer that takes the processor away the cycle stands for some periods and goes on where
// it was, while the drive went on with its velocity: the targets pull it back, and this is no fault
// of the axis.
class LateCycles : public DirectBusTest {
 protected:
  void accelerate() {
    switch_on();
    for (int i = 1; i <= 150; ++i) step(2.0 * i);  // 2000 mm/s2
  }
  void step(double velocity) {
    targets[0].position += velocity * 1e-3;
    targets[0].velocity = velocity;
    run(1);
  }
  void go_on_late() {
    for (int i = 0; i < 3; ++i) step(300.0);
    run(7);
  }
};

TEST_F(LateCycles, AreNoFaultOfAnAxisInARapid) {
  accelerate();
  for (int i = 0; i < 50; ++i) {
    go_on_late();
    ASSERT_FALSE(feedback[0].following_error_exceeded) << i;
    ASSERT_EQ(feedback[0].state, DriveState::operation_enabled) << i;
  }
}

TEST_F(LateCycles, HideNoAxisThatIsBlocked) {
  accelerate();
  go_on_late();
  bus.inject(0, FaultKind::jammed);
  int bursts = 0;
  while (!feedback[0].following_error_exceeded &&
         feedback[0].state == DriveState::operation_enabled) {
    go_on_late();
    ASSERT_LT(++bursts, 40);  // 0.4 s
  }
}

TEST_F(DirectBusTest, ASilentDriveIsInvalidAfterTheTimeout) {
  switch_on();
  bus.inject(0, FaultKind::off);
  run(240);
  EXPECT_TRUE(feedback[0].valid);
  run(30);
  EXPECT_FALSE(feedback[0].valid);
  EXPECT_TRUE(feedback[1].valid);
  EXPECT_GT(bus.status().errors[drives::ExchangeError::timeout], 20U);
}

TEST(DirectBus, GivesTheSameBitsEveryRun) {
  const auto trace = [] {
    DirectBus bus(two_axis_bus(), drives_of(two_axis_bus(), {}), 1.0 * millisecond);
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

// The way of a homing: a drive that counts from where it stood, a pulse, and the offset that makes
// its count the position of the machine.
TEST(DirectBus, AnIncrementalDriveIsReferencedByTheOffsetThatTheControlFinds) {
  drives::BusConfig bus_config = two_axis_bus();
  bus_config.axes.resize(1);
  bus_config.axes[0].absolute_encoder = false;
  auto simulated = drives_of(bus_config, std::array<double, 1>{37.5});
  simulated[0].reference = {.absolute_encoder = false, .index_position = 2.0, .index_pitch = 10.0};
  DirectBus bus(bus_config, simulated, 1.0 * millisecond);
  std::array<drives::DriveTarget, 1> target{};
  std::array<drives::DriveFeedback, 1> feedback{};
  const auto run = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      bus.write(target);
      bus.read(feedback);
    }
  };
  target[0] = {.enabled = true, .brake_closed = false};
  run(50);
  ASSERT_EQ(feedback[0].state, DriveState::operation_enabled);
  EXPECT_EQ(feedback[0].position, 0.0);
  EXPECT_FALSE(feedback[0].referenced);
  while (feedback[0].index_count == 0) {
    target[0].position += 0.005;
    target[0].velocity = 5.0;
    run(1);
    ASSERT_LT(target[0].position, 20.0);
  }
  target[0].velocity = 0.0;
  run(200);
  EXPECT_EQ(feedback[0].index_position, 4.5);  // 42 mm of the machine
  const double offset = 42.0 - feedback[0].index_position;
  target[0].position_offset = offset;
  target[0].position += offset;
  target[0].position_accepted = true;
  run(20);
  target[0].position_accepted = false;
  run(50);
  EXPECT_TRUE(feedback[0].referenced);
  EXPECT_EQ(feedback[0].position, feedback[0].target_position);
  EXPECT_NEAR(feedback[0].position, 42.0, 0.1);
  EXPECT_EQ(feedback[0].index_position, 42.0);
  EXPECT_EQ(feedback[0].state, DriveState::operation_enabled) << "no step in its target";
  bus.inject(0, FaultKind::off);
  run(400);
  bus.inject(0, FaultKind::none);
  run(1000);
  ASSERT_TRUE(feedback[0].valid);
  EXPECT_FALSE(feedback[0].referenced);
}

TEST_F(DirectBusTest, AllocatesNothing) {
  const testing::NoAllocation guard;
  run(20);
}

}  // namespace
}  // namespace stanok::plant
