// Drives that fall silent or trip while a program runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::HasSubstr;

using testing::MachineBench;

// Channel 1 moves; the feedback of its axes is what the test says.
class DriveFaults : public ::testing::Test {
 protected:
  DriveFaults() : drives(axes.size()) {
    for (AxisFeedback& drive : drives) drive = {.valid = true, .enabled = true, .referenced = true};
    bench.feedback(drives);
    bench.program("p.nc", "G1 X100 F6000\nM30\n");
    bench.run(1, "p.nc");
    for (int n = 0; n < 200; ++n) bench.cycle();
    EXPECT_TRUE(bench.channel(1).moving);
  }
  // The alarm that comes of it.
  [[nodiscard]] std::string alarm() {
    bench.feedback(drives);
    bench.cycle();
    const auto alarms = bench.machine().alarms();
    return alarms.size() == 1 ? alarms[0].diagnostic.code + " " + alarms[0].diagnostic.message
                              : std::to_string(alarms.size()) + " alarms";
  }

  MachineBench bench;
  NumberedList<AxisConfig> axes = testing::two_channel_machine().axes;
  std::vector<AxisFeedback> drives;
};

TEST_F(DriveFaults, TheAlarmNamesTheAxisOfTheDrive) {
  drives[1].fault = true;
  EXPECT_EQ(alarm(), "A3002 the drive of axis " + axes[1].name + " reports a fault");
}

TEST_F(DriveFaults, AnAxisThatDoesNotFollowIsNamed) {
  drives[1].strays = true;
  EXPECT_EQ(alarm(), "A3003 the drive of axis " + axes[1].name +
                         " does not follow its setpoints or report its position");
}

TEST_F(DriveFaults, ADriveThatSwitchesItselfOffStopsTheChannel) {
  drives[1].enabled = false;
  EXPECT_EQ(alarm(), "A3004 the drive of axis " + axes[1].name + " has switched itself off");
}

// Its position may be that of no machine any more.
TEST_F(DriveFaults, ADriveThatLosesItsReferenceStopsTheChannel) {
  drives[1].referenced = false;
  EXPECT_EQ(alarm(), "A3005 the drive of axis " + axes[1].name + " has lost its reference");
  for (int n = 0; n < 500; ++n) bench.cycle();
  EXPECT_FALSE(bench.channel(1).moving);
  EXPECT_LT(bench.channel(1).axes[0].position, 20.0);
}

TEST_F(DriveFaults, ABusThatFallsSilentIsOneAlarmOfAllItsAxes) {
  for (AxisFeedback& drive : drives) drive.valid = false;
  EXPECT_THAT(alarm(), HasSubstr("A3001 the drives of axes " + axes[0].name + ", " + axes[1].name));
}

// What is no number is no answer, whichever way it came.
TEST_F(DriveFaults, AValueThatIsNoNumberIsNoAnswer) {
  drives[0].position = std::nan("");
  EXPECT_THAT(alarm(), HasSubstr("A3001 the drive of axis " + axes[0].name));
  for (int n = 0; n < 500; ++n) {
    const ChannelOutput& channel = bench.cycle().channels[0];
    for (const AxisSetpoint& axis : channel.axes) ASSERT_TRUE(std::isfinite(axis.position));
  }
}

// In a hold: on the way aside, on the way back to the path, and on the way back along it.
class DriveFaultsInHold : public DriveFaults, public ::testing::WithParamInterface<int> {
 protected:
  void ask(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    bench.ask(event);
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  void begin_move(int which) {
    const commands::Jog jog{.axis = ShortText("Z"), .velocity = 50.0, .increment = 20.0};
    if (which < 2) ask(jog);
    if (which == 1) {
      cycles(2000);
      ask(commands::ProgramReturn{.velocity = 50.0});
    }
    if (which == 2)
      ask(commands::ProgramRetrace{.direction = RetraceDirection::back, .length = 10.0});
    cycles(100);
  }
};

TEST_P(DriveFaultsInHold, StopTheAxesAndEndTheRun) {
  bench.may_refuse();  // the way back that does not come to its end
  ask(commands::ProgramHold{});
  cycles(400);
  ASSERT_EQ(bench.channel(1).state, ChannelState::held);
  begin_move(GetParam());
  ASSERT_TRUE(bench.channel(1).moving);
  ASSERT_TRUE(bench.channel(1).aside);
  drives[1].fault = true;
  EXPECT_EQ(alarm(), "A3002 the drive of axis " + axes[1].name + " reports a fault");
  std::array<double, 3> before{};
  double fastest = 0.0;
  for (int n = 0; n < 1000; ++n) {
    bench.cycle();
    for (std::size_t k = 0; k < before.size(); ++k) {
      const double now = bench.channel(1).axes[k].position;
      if (n > 0) fastest = std::max(fastest, std::abs(now - before[k]));
      before[k] = now;
    }
  }
  EXPECT_LT(fastest, 0.11) << "no axis jumps: 100 mm/s at most";
  EXPECT_FALSE(bench.channel(1).moving);
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_FALSE(bench.channel(1).aside);
  EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_FALSE(bench.channel(1).drives[k].enabled) << k;
}

INSTANTIATE_TEST_SUITE_P(OfMoves, DriveFaultsInHold, ::testing::Values(0, 1, 2));

}  // namespace
}  // namespace stanok::channels
