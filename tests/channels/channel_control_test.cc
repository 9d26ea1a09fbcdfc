// A channel that a session has to itself: what comes by way of programs, axes and commands that are
// under way already.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::machine_of_one_axis_channels;
using testing::machine_with_a_shared_axis;
using testing::MachineBench;

constexpr int ours = 7;
constexpr int theirs = 8;

class ChannelControlOfPrograms : public ::testing::TestWithParam<const char*> {
 protected:
  void give(int channel, int session) {
    bench.ask(OperatorAction::channel_control, channel, "", 0.0, session);
    bench.cycle();
  }
  // Channel 2 does it to channel 1.
  void run_master() {
    bench.program("work.nc", "G1 X10 F6000\nM30\n");
    bench.program("master.nc", std::string(GetParam()) + "\nchannel_wait (1);\nM30\n");
    bench.run(2, "master.nc");
    bench.run_to_end([&](const CycleOutput&) {
      way = std::max(way, std::abs(bench.channel(1).axes[0].position - start));
    });
  }

  MachineBench bench{machine_of_one_axis_channels(2)};
  double start = bench.cycle().channels[0].axes[0].position;
  double way = 0.0;
};

TEST_P(ChannelControlOfPrograms, AreKeptFromAChannelThatAnotherHas) {
  bench.may_refuse();
  bench.ask(OperatorAction::program_load, 1, "work.nc");
  give(1, ours);
  run_master();
  EXPECT_EQ(bench.alarm_codes().size(), 1u);
  EXPECT_THAT(to_text(bench.machine().alarms().at(0).diagnostic), HasSubstr("E6080"));
  EXPECT_EQ(way, 0.0) << "nothing moved";
}

TEST_P(ChannelControlOfPrograms, ActForWhoeverHasTheirOwnChannel) {
  give(1, ours);
  give(2, ours);
  run_master();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(way, 10.0, 1e-9);
}

TEST_P(ChannelControlOfPrograms, AreKeptOutWhenSomebodyElseHasTheirOwnChannel) {
  give(1, ours);
  give(2, theirs);
  run_master();
  EXPECT_EQ(way, 0.0);
}

TEST_P(ChannelControlOfPrograms, AreFreeAgainWhenTheChannelIsGivenBack) {
  give(1, ours);
  give(1, 0);
  run_master();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(way, 10.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Ways, ChannelControlOfPrograms,
                         ::testing::Values("channel_run (1, \"work.nc\");",
                                           "channel_load (1, \"work.nc\");\nchannel_start (1);"));

// A program that runs goes on; only what begins is refused, and a stop works.
TEST(ChannelControl, LeavesStopsOfProgramsAlone) {
  MachineBench bench{machine_of_one_axis_channels(2)};
  bench.program("work.nc", "G1 X100 F6000\nM30\n");
  bench.program("master.nc", "channel_run (1, \"work.nc\");\nG4 P0.3\nchannel_stop (1);\nM30\n");
  bench.run(2, "master.nc");
  for (int k = 0; k < 100; ++k) bench.cycle();
  bench.ask(OperatorAction::channel_control, 1, "", 0.0, ours);
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).state, ChannelState::held);
}

// What was asked for before and has not begun does not begin any more.
TEST(ChannelControl, KeepsBackACommandThatWasAskedForBefore) {
  MachineBench bench{machine_of_one_axis_channels(1)};
  bench.program("work.nc", "G1 X10 F6000\nM30\n");
  bench.run(1, "work.nc");
  bench.ask(OperatorAction::channel_control, 1, "", 0.0, ours);
  bench.run_to_end();
  ASSERT_EQ(bench.replies().size(), 2u);
  EXPECT_EQ(bench.replies()[1].code.view(), "E6080");
  bench.run(1, "work.nc");
  bench.run_to_end();
  EXPECT_TRUE(bench.replies().back().ok) << "its own commands begin";
}

TEST(ChannelControl, CoversTheAxesThatTheChannelHas) {
  MachineBench bench{machine_with_a_shared_axis()};
  bench.ask(OperatorAction::kinematics_select, 2, "", 0.0, 2);  // C belongs to channel 2 now
  bench.run_to_end();
  bench.ask(OperatorAction::channel_control, 2, "", 0.0, ours);
  bench.program("claims.nc", "#kinematics (1, 2)\nM30\n");
  bench.run(1, "claims.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E6080"));
  bench.ask(OperatorAction::channel_control, 2, "", 0.0, 0);
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  bench.run(1, "claims.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E6080")) << "no other one";
}

}  // namespace
}  // namespace stanok::channels
