// M99 in the main program: a machine begins the program again until somebody stops it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using stanok::testing::MachineBench;
using stanok::testing::two_channel_machine;
using ::testing::IsEmpty;

TEST(ProgramRestart, GoesOnInTheSameRunUntilReset) {
  MachineBench bench(two_channel_machine(), {.on_at_start = true});
  bench.program("p.nc", "G1 F6000\nG91 X1\nM99\n");
  bench.run(1, "p.nc");
  for (int cycle = 0; cycle < 20000 && bench.output().channels[0].axes[0].position < 5.5; ++cycle) {
    bench.cycle();
    EXPECT_LE(bench.output().channels[0].run, 1u);
  }
  EXPECT_EQ(bench.channel(1).state, ChannelState::running);
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST(ProgramRestart, TheOutputNamesTheProgramOfTheRun) {
  MachineBench bench(two_channel_machine(), {.on_at_start = true});
  bench.program("p.nc", "G4 P0.1\nX1 F6000\nM30\n");
  bench.program("q.nc", "G1 X0 F6000\nM30\n");
  bench.cycle();
  EXPECT_EQ(bench.channel(1).program.view(), "");
  bench.run(1, "p.nc");
  for (int cycle = 0; cycle < 50; ++cycle) bench.cycle();
  EXPECT_EQ(bench.channel(1).program.view(), "p.nc");
  EXPECT_EQ(bench.channel(2).program.view(), "");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).program.view(), "p.nc") << "also when it is over";
  bench.run(1, "q.nc");
  bench.run_to_end([](const channels::CycleOutput& output) {
    const channels::ChannelOutput& channel = output.channels[0];
    if (channel.tag.run == 2 && channel.tag.line != 0) {
      EXPECT_EQ(channel.program.view(), "q.nc");
    }
  });
  EXPECT_EQ(bench.channel(1).program.view(), "q.nc");
}

TEST(ProgramRestart, TakesTheSkipSwitchOverInBetween) {
  MachineBench bench(two_channel_machine(), {.on_at_start = true});
  bench.program("p.nc", "G1 F6000\n/M30\nX1\nX0\nM99\n");
  bench.ask(OperatorAction::block_skip, 1, "", 0.0, 1);
  bench.run(1, "p.nc");
  for (int cycle = 0; cycle < 1000; ++cycle) bench.cycle();
  EXPECT_EQ(bench.channel(1).state, ChannelState::running);
  bench.ask(OperatorAction::block_skip_off, 1, "", 0.0, 1);
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
}

TEST(ProgramRestart, EndsASimulatedRun) {
  MachineBench bench;
  bench.program("p.nc", "G1 X10 F6000\nM99\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
}

}  // namespace
}  // namespace stanok::channels
