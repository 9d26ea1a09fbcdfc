// Faults of our own while axes move: the channel stops along its path with an alarm, the others go
// on, and nothing that no axis can follow reaches a drive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "tests/support/cycle.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::HasSubstr;
using testing::MachineBench;

// Limits that the reader of machine files would refuse: planning a path along such an axis breaks
// its own claims.
constexpr double impossible_jerk = 1e-300;

MachineConfig machine_with_an_impossible_jerk() {
  MachineConfig config = testing::two_channel_machine();
  config.axes[1].limits.jerk_max = impossible_jerk;
  return config;
}

// A long way along X, then the block that cannot be planned.
constexpr const char* long_way_then_Y = "G64\nG1 X100 F6000\nX200\nX240\nX240 Y20\nM30\n";

TEST(BrokenClaims, NameFileLineAndClaim) {
  try {
    STANOK_ASSERT(1 + 1 == 3);
    FAIL();
  } catch (const BrokenClaim& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("tests/channels/own_faults_test.cc:"));
    EXPECT_THAT(fault.what(), HasSubstr("broken claim: 1 + 1 == 3"));
  }
}

// The way to a rest that is left after the program went wrong obeys the limits of X.
TEST(BrokenClaims, OfAPreparationStopItsChannelAlongThePath) {
  MachineBench bench(machine_with_an_impossible_jerk());
  bench.program("p.nc", long_way_then_Y);
  bench.run(1, "p.nc");
  double jerk_max = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const auto& x = output.channels[0].axes[0];
    ASSERT_TRUE(std::isfinite(x.position) && std::isfinite(x.velocity));
    ASSERT_EQ(output.channels[0].axes[1].position, 0.0);
    jerk_max = std::max(jerk_max, std::abs(x.jerk));
  });
  EXPECT_LE(jerk_max, 50000.0 * (1.0 + 1e-9));
  EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  EXPECT_THAT(bench.alarm_codes(), ::testing::ElementsAre("A9001"));
}

TEST(BrokenClaims, LeaveTheOtherChannelsAlone) {
  MachineConfig config = testing::machine_of_one_axis_channels(2);
  config.axes[0].limits.jerk_max = impossible_jerk;
  MachineBench bench(config);
  bench.program("p.nc", "G1 X100 F6000\nM30\n");
  bench.run(1, "p.nc");
  bench.run(2, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).axes[0].position, 0.0);
  EXPECT_EQ(bench.channel(2).axes[0].position, 100.0);
  EXPECT_THAT(bench.alarm_codes(), ::testing::ElementsAre("A9001"));
}

TEST(BrokenClaims, AreOverWithAReset) {
  MachineBench bench(machine_with_an_impossible_jerk());
  bench.program("p.nc", long_way_then_Y);
  bench.program("q.nc", "G1 X10 F6000\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  bench.run(1, "q.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).axes[0].position, 10.0);
  EXPECT_NE(bench.channel(1).state, ChannelState::alarm);
}

// A jerk of nothing makes phases that last for ever: their setpoints are no numbers.
TEST(SetpointGuard, LetsNothingThroughThatIsNoNumber) {
  MachineConfig config = testing::two_channel_machine();
  config.axes[1].limits.jerk_max = 0.0;
  MachineBench bench(config);
  bench.program("p.nc", long_way_then_Y);
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) {
    for (const AxisSetpoint& axis : output.channels[0].axes) {
      ASSERT_TRUE(std::isfinite(axis.position) && std::isfinite(axis.velocity));
      ASSERT_TRUE(std::isfinite(axis.acceleration) && std::isfinite(axis.jerk));
    }
  });
  EXPECT_THAT(bench.alarm_codes(), ::testing::ElementsAre("A9002"));
  EXPECT_EQ(bench.channel(1).axes[1].position, 0.0);
  EXPECT_FALSE(bench.channel(1).drives[1].enabled);
}

}  // namespace
}  // namespace stanok::channels
