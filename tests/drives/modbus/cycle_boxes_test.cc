// What crosses between cycle and bus thread, and whether the cycle still writes.
#include "drives/modbus/cycle_boxes.h"

#include <gtest/gtest.h>

#include <vector>

#include "drives/modbus/target_watch.h"
#include "tests/support/no_allocation.h"

namespace stanok::drives {
namespace {

using std::chrono::milliseconds;

TEST(CycleBoxes, CarriesTargetsThereAndFeedbackBack) {
  CycleBoxes boxes(2, 10 * millisecond, 1 * millisecond);
  std::vector<DriveTarget> targets(3);
  targets[0].position = 1.5;
  targets[1].position = -2.5;
  std::vector<DriveFeedback> read(3);
  {
    const testing::NoAllocation guard;
    boxes.write(targets, BusTime{0});
    boxes.read(read);
  }
  EXPECT_EQ(boxes.target(0, BusTime{0}).position, 1.5);
  EXPECT_EQ(boxes.target(1, BusTime{0}).position, -2.5);
  EXPECT_EQ(boxes.writes(), 1U);
  DriveFeedback feedback;
  feedback.position = 7.0;
  boxes.publish(1, feedback);
  boxes.read(read);
  EXPECT_EQ(read[1].position, 7.0);
}

// At 250 mm/s with a cycle of 1 ms: the target is for the end of the cycle, and the drive bridges
// 100 ms behind it.
TEST(CycleBoxes, ATargetOfALateCycleIsCarriedOn) {
  CycleBoxes boxes(3, 250 * millisecond, 1 * millisecond);
  DriveTarget moving{.position = 10.0, .velocity = 250.0, .enabled = true};
  DriveTarget turning = moving;
  turning.mode = OperationMode::cyclic_synchronous_velocity;
  DriveTarget off = moving;
  off.enabled = false;
  boxes.write(std::vector{moving, turning, off}, milliseconds(40));
  EXPECT_EQ(boxes.target(0, milliseconds(40)).position, 10.0);
  EXPECT_EQ(boxes.target(0, milliseconds(41)).position, 10.0);
  EXPECT_NEAR(boxes.target(0, milliseconds(44)).position, 10.75, 1e-12);
  EXPECT_NEAR(boxes.target(0, milliseconds(400)).position, 35.0, 1e-12);
  EXPECT_EQ(boxes.target(1, milliseconds(44)).position, 10.0);
  EXPECT_EQ(boxes.target(2, milliseconds(44)).position, 10.0);
}

TEST(CycleBoxes, FeedbackThatDoesNotChangeForTheTimeOutIsInvalid) {
  CycleBoxes boxes(1, 3 * millisecond, 1 * millisecond);
  DriveFeedback feedback;
  feedback.valid = true;
  feedback.sequence = 1;
  boxes.publish(0, feedback);
  std::vector<DriveFeedback> read(1);
  for (std::uint32_t age = 0; age <= 4; ++age) {
    boxes.read(read);
    EXPECT_EQ(read[0].age_cycles, age);
    EXPECT_EQ(read[0].valid, age <= 3);
  }
  feedback.sequence = 2;
  boxes.publish(0, feedback);
  boxes.read(read);
  EXPECT_TRUE(read[0].valid);
}

TEST(CycleBoxes, CarriesSignals) {
  CycleBoxes boxes(0, 3 * millisecond, 1 * millisecond);
  Signals signals;
  signals.digital = 5;
  boxes.write_signals(signals);
  EXPECT_EQ(boxes.outputs(), signals);
  boxes.publish_inputs(signals);
  EXPECT_EQ(boxes.read_signals(), signals);
}

TEST(TargetWatch, TargetsAreStaleWhenNoneCameForTheTimeOut) {
  TargetWatch watch(milliseconds{50});
  EXPECT_EQ(watch.age(1, milliseconds{10}), TargetAge::fresh);
  EXPECT_EQ(watch.age(1, milliseconds{60}), TargetAge::fresh);
  EXPECT_EQ(watch.age(1, milliseconds{61}), TargetAge::stale);
  EXPECT_EQ(watch.age(2, milliseconds{70}), TargetAge::fresh);
}

}  // namespace
}  // namespace stanok::drives
