// Encoder, index pulses and switches of a feed axis.
#include "plant/mechanics/measuring_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stanok::plant {
namespace {

ReferenceConfig incremental() {
  return {.absolute_encoder = false,
          .home_switch_from = -5.0,
          .home_switch_to = 0.0,
          .limit_negative = -100.0,
          .limit_positive = 300.0,
          .index_position = 2.0,
          .index_pitch = 10.0};
}

TEST(MeasuringSystem, AnIncrementalEncoderCountsFromWhereItIsSwitchedOn) {
  EXPECT_EQ(MeasuringSystem(incremental(), 37.5).zero(), 37.5);
  EXPECT_EQ(MeasuringSystem({}, 37.5).zero(), 0.0);
  MeasuringSystem measuring(incremental(), 37.5);
  measuring.take(40.0);
  measuring.restart();
  EXPECT_EQ(measuring.zero(), 40.0);
}

TEST(MeasuringSystem, LatchesTheExactPlaceOfAPulseInBothDirections) {
  MeasuringSystem measuring(incremental(), 37.5);
  measuring.take(41.9);
  EXPECT_EQ(measuring.index_count(), 0);
  measuring.take(42.7);
  EXPECT_EQ(measuring.index_count(), 1);
  EXPECT_EQ(measuring.index_position(), 4.5);  // 42 of the machine, counted from 37.5
  measuring.take(30.0);
  EXPECT_EQ(measuring.index_count(), 3);
  EXPECT_EQ(measuring.index_position(), -5.5);  // 32, the last of the two on the way
}

// Against a count of the pulses between the two places, on a grid where no place is a pulse.
TEST(MeasuringSystem, CountsEveryPulseOfAnyWay) {
  const unsigned seed = 60;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(-100000, 100000);
  MeasuringSystem measuring(incremental(), 0.5);
  double before = 0.5;
  std::uint16_t count = 0;
  for (int i = 0; i < 2000; ++i) {
    const double after = 0.001 * any(random) + 0.0005;
    for (int pulse = -998; pulse < 1000; pulse += 10) {
      if ((before < pulse) != (after < pulse)) ++count;
    }
    measuring.take(after);
    ASSERT_EQ(measuring.index_count(), count) << "seed " << seed << ", step " << i;
    before = after;
  }
}

TEST(MeasuringSystem, SwitchesAreActiveWhereTheyStand) {
  MeasuringSystem measuring(incremental(), 0.0);
  EXPECT_TRUE(measuring.on_home_switch());
  measuring.take(0.001);
  EXPECT_FALSE(measuring.on_home_switch());
  EXPECT_FALSE(measuring.on_limit_positive());
  measuring.take(300.0);
  EXPECT_TRUE(measuring.on_limit_positive());
  measuring.take(-100.0);
  EXPECT_TRUE(measuring.on_limit_negative());
  EXPECT_FALSE(measuring.on_limit_positive());
}

TEST(MeasuringSystem, WithoutSwitchesNoneIsActive) {
  MeasuringSystem measuring({}, 0.0);
  for (const double position : {-1e9, 0.0, 1e9}) {
    measuring.take(position);
    EXPECT_FALSE(measuring.on_home_switch() || measuring.on_limit_negative() ||
                 measuring.on_limit_positive());
  }
}

// The switch on the load is met half the play later from either side.
TEST(MeasuringSystem, BacklashShiftsASwitchByThePlayBetweenTheDirections) {
  ReferenceConfig config = incremental();
  config.backlash = 0.2;
  MeasuringSystem measuring(config, 50.0);
  double downwards = 50.0;
  while (!measuring.on_home_switch()) measuring.take(downwards -= 0.001);
  measuring.take(-1.0);
  double upwards = -1.0;
  while (measuring.on_home_switch()) measuring.take(upwards += 0.001);
  EXPECT_NEAR(downwards, -0.1, 0.0015);
  EXPECT_NEAR(upwards, 0.1, 0.0015);
}

}  // namespace
}  // namespace stanok::plant
