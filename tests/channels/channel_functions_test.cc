// What channels ask of each other: load, start, run, wait, stop, reset, and who owns a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::machine_of_one_axis_channels;
using testing::MachineBench;

class ChannelFunctionsTest : public ::testing::Test {
 protected:
  // Channel 2 runs `master`.
  void run_master(const std::string& master) {
    bench.program("master.nc", master);
    bench.run(2, "master.nc");
    bench.run_to_end();
  }
  [[nodiscard]] std::string alarm_text_of(int channel) {
    for (const auto& alarm : bench.machine().alarms()) {
      if (alarm.channel == channel) return to_text(alarm.diagnostic);
    }
    return "";
  }

  MachineBench bench{machine_of_one_axis_channels(3)};
};

TEST_F(ChannelFunctionsTest, WaitAsAStatementNamesChannelAlarmFileAndLine) {
  bench.program("work.nc", "G4 P0.1\nG1 X1 F600\nX9999\nM30\n");
  run_master("channel_run (1, \"work.nc\");\nchannel_wait (1);\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5101", "E6010"));
  EXPECT_THAT(alarm_text_of(2), HasSubstr("channel 1 ended with alarm E5101 (work.nc:3)"));
  EXPECT_THAT(alarm_text_of(2), HasSubstr("master.nc:2:1"));
}

TEST_F(ChannelFunctionsTest, WaitInAnExpressionGoesOnAndTellsWhy) {
  bench.program("work.nc", "terminate (1234, \"worn\");\n");
  run_master(
      "channel_run (1, \"work.nc\");\n"
      "if (channel_wait (1) == false) { terminate (1005, channel_error ()); }\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("U1234", "U1005"));
  EXPECT_THAT(alarm_text_of(2), HasSubstr("E6010 channel 1 ended with alarm U1234 (work.nc:1)"));
}

TEST_F(ChannelFunctionsTest, EachFunctionHasItsOwnCodeAsAStatement) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"channel_load (1, \"absent.nc\");", "E6011"},
      {"channel_start (3);", "E6012"},
      {"channel_run (1, \"absent.nc\");", "E6013"},
      {"channel_stop (1);", "E6014"},
  };
  for (const auto& [call, code] : cases) {
    MachineBench fresh(machine_of_one_axis_channels(3));
    fresh.program("master.nc", call + "\nM30\n");
    fresh.run(2, "master.nc");
    fresh.run_to_end();
    EXPECT_THAT(fresh.alarm_codes(), ElementsAre(code)) << call;
  }
}

TEST_F(ChannelFunctionsTest, ShortProgramIsNotMissed) {
  bench.program("work.nc", "M30\n");
  run_master("channel_run (1, \"work.nc\");\nG4 P1\nchannel_wait (1);\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST_F(ChannelFunctionsTest, TimeoutIsFalseAndTheTargetGoesOn) {
  bench.program("work.nc", "G4 P2\nM30\n");
  run_master(
      "channel_run (1, \"work.nc\");\n"
      "if (channel_wait (1, 0.5)) { terminate (1001, \"too good\"); }\n"
      "if (channel_state (1) != CH_RUNNING) { terminate (1002, \"state\"); }\n"
      "channel_wait (1, 10);\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST_F(ChannelFunctionsTest, StopHoldsAndStartGoesOn) {
  bench.program("work.nc", "G1 X100 F6000\nM30\n");
  run_master(
      "channel_run (1, \"work.nc\");\nG4 P0.2\nchannel_stop (1);\n"
      "if (channel_state (1) != CH_HELD) { terminate (1001, \"not held\"); }\n"
      "channel_start (1);\nchannel_wait (1);\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, 100.0);
}

TEST_F(ChannelFunctionsTest, HeldTargetKeepsTheWaitGoing) {
  bench.program("work.nc", "G1 X100 F6000\nM30\n");
  bench.program("master.nc", "channel_run (1, \"work.nc\");\nchannel_wait (1);\nM30\n");
  bench.run(2, "master.nc");
  for (int n = 0; n < 300; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  bench.run_to_end();
  EXPECT_TRUE(bench.channel(2).waiting);
  EXPECT_EQ(bench.channel(2).wait.cause, WaitCause::end);
  EXPECT_EQ(bench.channel(2).wait.channels, 1U << 1U);
  bench.ask(OperatorAction::program_resume, 1);
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_FALSE(bench.channel(2).running);
  EXPECT_EQ(bench.channel(2).wait.cause, WaitCause::nothing);
}

TEST_F(ChannelFunctionsTest, StopOfTheWaitingChannelHoldsItsWait) {
  bench.program("work.nc", "G4 P1\nM30\n");
  bench.program("master.nc", "channel_run (1, \"work.nc\");\nchannel_wait (1, 3);\nM30\n");
  bench.run(2, "master.nc");
  for (int n = 0; n < 300; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 2);
  for (int n = 0; n < 5000; ++n) bench.cycle();
  EXPECT_EQ(bench.channel(2).state, ChannelState::held);
  bench.ask(OperatorAction::program_resume, 2);
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty()) << "its time did not run on while it was held";
}

TEST_F(ChannelFunctionsTest, WaitAfterAResetIsTrueAndDuringItFalse) {
  bench.program("work.nc", "G4 P5\nM30\n");
  run_master(
      "channel_run (1, \"work.nc\");\nchannel_reset (1);\n"
      "if (channel_state (1) != CH_READY) { terminate (1001, \"not ready\"); }\n"
      "channel_wait (1);\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  bench.program("master.nc", "channel_run (1, \"work.nc\");\nchannel_wait (1);\nM30\n");
  bench.run(2, "master.nc");
  for (int n = 0; n < 300; ++n) bench.cycle();
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E6010"));
  EXPECT_THAT(alarm_text_of(2), HasSubstr("channel 1 was reset"));
}

TEST_F(ChannelFunctionsTest, OwnChannelAndUnknownChannelsAreErrors) {
  run_master("num target = 2;\nif (channel_wait (target)) { M0\n }\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E6031"));
  bench.ask(OperatorAction::program_reset, 2);
  bench.run_to_end();
  run_master("num target = 7;\nif (channel_wait (target)) { M0\n }\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E6031", "E6001"));
}

// What becomes of a run whose owner fails, and of one whose owner ends well.
struct OwnerCase {
  const char* name;
  OwnerFailure rule;
  const char* end_of_master;
  bool goes_on;
  ChannelState state;
};

class OwnerTest : public ::testing::TestWithParam<OwnerCase> {};

TEST_P(OwnerTest, RunFollowsItsOwner) {
  MachineConfig config = machine_of_one_axis_channels(2);
  config.channels[0].on_owner_failure = GetParam().rule;
  MachineBench bench(std::move(config));
  bench.program("work.nc", "G1 X100 F6000\nM30\n");
  bench.program("master.nc",
                "channel_run (1, \"work.nc\");\nG4 P0.2\n" + std::string(GetParam().end_of_master));
  bench.run(2, "master.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, GetParam().state);
  EXPECT_EQ(bench.channel(1).axes[0].position == 100.0, GetParam().goes_on);
}

INSTANTIATE_TEST_SUITE_P(
    Rules, OwnerTest,
    ::testing::Values(OwnerCase{"Hold", OwnerFailure::hold, "terminate (1001, \"\");\n", false,
                                ChannelState::held},
                      OwnerCase{"Continue", OwnerFailure::continue_run, "terminate (1001, \"\");\n",
                                true, ChannelState::ready},
                      OwnerCase{"Reset", OwnerFailure::reset, "terminate (1001, \"\");\n", false,
                                ChannelState::ready},
                      OwnerCase{"NormalEnd", OwnerFailure::hold, "M30\n", true,
                                ChannelState::ready}),
    [](const auto& test) { return test.param.name; });

TEST_F(ChannelFunctionsTest, SwitchingOnNamesTheChannelsThatNeedAReset) {
  bench.ask(OperatorAction::machine_estop, 0);
  for (int n = 0; n < 10; ++n) bench.cycle();
  bench.ask(OperatorAction::program_reset, 2);
  for (int n = 0; n < 10; ++n) bench.cycle();
  bench.ask(OperatorAction::machine_on, 0);
  for (int n = 0; n < 3; ++n) bench.cycle();
  const OperatorReply& reply = bench.replies().back();
  EXPECT_FALSE(reply.ok);
  EXPECT_EQ(reply.code.view(), "E6004");
  EXPECT_THAT(std::string(reply.text.view()), HasSubstr("channels 1, 3 must be reset first"));
}

}  // namespace
}  // namespace stanok::channels
