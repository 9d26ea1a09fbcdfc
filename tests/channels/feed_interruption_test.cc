// The operator's interruption of the feed on a running program: places and times by counting.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>

#include "tests/support/cycle.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::cycle_s;
using ::testing::IsEmpty;
using testing::MachineBench;

OperatorEvent interruption(double la, double lb, int channel = 1) {
  OperatorEvent event;
  event.command = commands::ProcessInterrupt{.stand_mm = la, .cut_mm = lb};
  event.channel = channel;
  return event;
}

struct StandingTime {
  double z = 0.0;
  double time_s = 0.0;
};

// Collects the rests along Z.
struct RestWatch {
  std::vector<StandingTime> rests;
  bool stood = false;
  void operator()(const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.process.stands && !stood) rests.push_back({channel.axes[1].position, 0.0});
    stood = channel.process.stands;
    if (stood) rests.back().time_s += cycle_s;
  }
};

TEST(FeedInterruptionOfAChannel, RestsAtLBApartForTheTimeOfLA) {
  MachineBench bench(testing::turning_machine());
  bench.program("turn.nc", "G0 X60 Z0\nG94 G1 Z-20 F600\nM30\n");
  bench.run(1, "turn.nc");
  bench.ask(interruption(0.4, 2.0));
  RestWatch watch;
  bench.run_to_end(std::ref(watch));
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  ASSERT_EQ(watch.rests.size(), 9U);
  for (std::size_t k = 0; k < watch.rests.size(); ++k) {
    EXPECT_NEAR(watch.rests[k].z, -2.0 * static_cast<double>(k + 1), 1e-8);
    EXPECT_NEAR(watch.rests[k].time_s, 0.4 / 600.0 * 60.0, 2.0 * cycle_s);
  }
}

// 0.2 mm/rev at 1200 rev/min are 4 mm/s.
TEST(FeedInterruptionOfAChannel, CountsTheFeedPerRevolution) {
  MachineBench bench(testing::turning_machine());
  bench.program("turn.nc", "G0 X60 Z0\nS1200 M3\nG95 G1 Z-9 F0.2\nM30\n");
  bench.run(1, "turn.nc");
  bench.ask(interruption(0.2, 3.0));
  RestWatch watch;
  bench.run_to_end(std::ref(watch));
  ASSERT_EQ(watch.rests.size(), 2U);
  EXPECT_NEAR(watch.rests[1].z, -6.0, 1e-8);
  EXPECT_NEAR(watch.rests[1].time_s, 0.05, 2.0 * cycle_s);
}

TEST(FeedInterruptionOfAChannel, EndsWithTheProgram) {
  MachineBench bench(testing::turning_machine());
  bench.program("turn.nc", "G0 X60 Z0\nG94 G1 Z-6 F600\nM30\n");
  bench.run(1, "turn.nc");
  bench.ask(interruption(0.4, 2.0));
  RestWatch first;
  bench.run_to_end(std::ref(first));
  EXPECT_EQ(first.rests.size(), 2U);
  bench.run(1, "turn.nc");
  RestWatch second;
  bench.run_to_end(std::ref(second));
  EXPECT_THAT(second.rests, IsEmpty());
}

TEST(FeedInterruptionOfAChannel, StopAndResetLeaveNoRestBehind) {
  MachineBench bench(testing::turning_machine());
  bench.program("turn.nc", "G0 X60 Z0\nG94 G1 Z-6 F60\nM30\n");
  bench.run(1, "turn.nc");
  bench.ask(interruption(50.0, 1.0));
  while (!bench.cycle().channels[0].process.stands) {
  }
  bench.ask(OperatorAction::program_stop, 1);
  bench.run_to_end();
  EXPECT_FALSE(bench.channel(1).process.stands);
  EXPECT_EQ(bench.channel(1).process.interruption, motion::InterruptionLengths{});
  EXPECT_FALSE(bench.channel(1).running);
}

// The record of the command holds all that a replay needs.
TEST(FeedInterruptionOfAChannel, IsRecordedWithBothLengths) {
  MachineBench bench(testing::turning_machine());
  const std::array events{interruption(0.4, 2.5)};
  CycleOutput output;
  bench.machine().cycle({.events = events, .feedback = {}}, output);
  InputRecord record;
  ASSERT_TRUE(bench.machine().input_records().pop(record));
  const auto& command = std::get<OperatorCommand>(record.content);
  EXPECT_EQ(std::get<commands::ProcessInterrupt>(command).stand_mm, 0.4);
  EXPECT_EQ(std::get<commands::ProcessInterrupt>(command).cut_mm, 2.5);
}

TEST(FeedInterruptionOfAChannel, RefusesLengthsThatMakeNoSense) {
  MachineBench bench;
  for (const OperatorEvent& event :
       {interruption(0.4, 0.0), interruption(-1.0, 2.0), interruption(0.4, 1e-5),
        interruption(std::numeric_limits<double>::quiet_NaN(), 2.0), interruption(0.4, 2.0, 2)}) {
    bench.ask(event);
    bench.cycle();
    ASSERT_FALSE(bench.replies().empty());
    EXPECT_EQ(bench.replies().back().code.view(), "E6029");
  }
}

}  // namespace
}  // namespace stanok::channels
