// People and programs that get into each other's way: a client that dies while it jogs, a master
// that is aborted while its worker runs, commands at the wrong moment, overrides that jump, and a
// publisher that does not follow.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/daemon/daemon_bench.h"
#include "tests/daemon/setpoint_watch.h"

namespace stanok::daemon {
namespace {

using channels::ChannelState;

class ChannelFaults : public ::testing::Test {
 protected:
  void SetUp() override {
    bench.program("long.nc", "G90 G54\nG1 X600 F6000\nX100\nM30\n");
    bench.program("master.nc", "channel_run (1, \"long.nc\");\nchannel_wait (1);\nM30\n");
    bench.demand("machine.on");
    bench.cycles(300);
  }
  void watch(int cycles) {
    for (int n = 0; n < cycles && !HasFatalFailure(); ++n) setpoints.look(bench.cycle());
  }
  void run_master() {
    bench.demand("program.run", {{"program", "master.nc"}, {"channel", 2}});
    watch(500);
    ASSERT_TRUE(bench.channel(1).running && bench.channel(2).running);
    ASSERT_TRUE(bench.channel(1).moving);
  }

  DaemonBench bench;
  SetpointWatch setpoints;
};

// The lease is 200 ms; from 20 mm/s the axis then needs 20 / 4000 s and the ramps of its jerk,
// 2 * sqrt (20 / 100000) s in all: less than 30 cycles.
TEST_F(ChannelFaults, AJogThatNobodyRenewsAnyMoreStops) {
  for (int n = 0; n < 20; ++n) {  // a client that lives
    bench.demand("jog", {{"axis", "X"}, {"velocity", 20.0}});
    watch(100);
    ASSERT_TRUE(bench.channel(1).moving);
  }
  watch(200 - 100 + 30);  // it died: its last request is 100 cycles old
  EXPECT_FALSE(bench.channel(1).moving);
  EXPECT_EQ(bench.channel(1).axes[0].velocity, 0.0);
}

TEST_F(ChannelFaults, AMasterThatIsAbortedLeavesItsWorkerHeld) {
  run_master();
  bench.demand("program.reset", {{"channel", 2}});
  watch(500);
  EXPECT_FALSE(bench.channel(2).running);
  EXPECT_EQ(bench.channel(1).state, ChannelState::held);
  EXPECT_EQ(bench.channel(1).hold_cause, channels::HoldCause::owner_failed);
  EXPECT_FALSE(bench.channel(1).moving);
  bench.demand("program.resume");
  watch(100);
  EXPECT_TRUE(bench.channel(1).moving) << "an operator may go on";
}

TEST_F(ChannelFaults, AWorkerThatIsAbortedEndsItsMastersWait) {
  run_master();
  bench.demand("program.reset", {{"channel", 1}});
  watch(500);
  EXPECT_EQ(bench.channel(2).state, ChannelState::alarm);
  const auto alarms = bench.answer("alarm.list", {{"channel", 2}}, 1);
  ASSERT_TRUE(alarms.has_value() && *alarms);
  EXPECT_EQ((**alarms)["alarms"].at(0)["code"], "E6010");
}

TEST_F(ChannelFaults, KinematicsAreNotExchangedUnderAMovingProgram) {
  bench.demand("program.run", {{"program", "long.nc"}});
  watch(500);
  const auto refused = bench.answer("kinematics.select", {{"scheme", 2}}, 10);
  ASSERT_TRUE(refused.has_value() && !*refused);
  EXPECT_EQ(refused->error().code, "E5202");
  EXPECT_TRUE(bench.channel(1).moving);
  EXPECT_EQ(bench.channel(1).scheme, 1);
}

TEST_F(ChannelFaults, APoseOutOfReachStopsTheProgramBeforeIt) {
  bench.program("far.nc", "G90 G54\nG1 X100 F6000\nX2000\nM30\n");
  const auto outcome = bench.answer("program.run", {{"program", "far.nc"}, {"wait", "done"}});
  ASSERT_TRUE(outcome.has_value() && !*outcome);
  EXPECT_EQ(outcome->error().place.line, 3);
  EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  EXPECT_LE(bench.channel(1).axes[0].position, 450.0) << "the limit of the axis";
}

// Between 0 and its greatest value in every few cycles: within speed, and within the acceleration
// of a stop, which an override of 0 is.
TEST_F(ChannelFaults, OverridesThatJumpKeepTheLimits) {
  std::mt19937 random(7);
  bench.demand("program.run", {{"program", "long.nc"}});
  const auto& limits = mill_of_the_bench().machine.axes[0].limits;
  const double a_max = limits.acceleration_max * limits.stop_limits * (1.0 + 1e-6);
  int jumps = 0;
  for (; jumps < 2000 && bench.channel(1).running && !HasFatalFailure(); ++jumps) {
    static_cast<void>(bench.ask(0, "override.feed", {{"percent", jumps % 2 == 0 ? 0 : 200}}));
    for (unsigned n = 0; n < random() % 30; ++n) {
      setpoints.look(bench.cycle());
      ASSERT_LE(std::abs(bench.channel(1).axes[0].acceleration), a_max);
    }
  }
  EXPECT_GT(jumps, 100);
  bench.demand("override.feed", {{"percent", 0}});
  watch(500);
  EXPECT_FALSE(bench.channel(1).axes[0].velocity != 0.0) << "an override of 0 stands";
  bench.demand("override.feed", {{"percent", 100}});
  watch(20'000);
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready) << "and is no end";
}

// Nobody takes the outputs of the cycle: they are dropped and counted, and the machine goes on.
TEST(Publisher, ThatFallsBehindLosesOutputsAndNothingElse) {
  constexpr int kept = 16;
  constexpr int cycles = 5000;
  runtime::Assembly assembly({.file = mill_of_the_bench(),
                              .drives = runtime::DriveChoice::simulated,
                              .program_roots = {},
                              .machine = {},
                              .output_capacity = kept});
  std::int64_t last = 0;
  for (int n = 1; n <= cycles; ++n) {
    for (const int k : {0, 1}) static_cast<void>(assembly.machine().prepare(k));
    last = assembly.cycle({}).cycle;
  }
  EXPECT_EQ(last, cycles);
  EXPECT_GE(assembly.outputs_lost(), static_cast<std::uint64_t>(cycles - 2 * kept));
  EXPECT_EQ(assembly.outputs_lost() + assembly.outputs().size(),
            static_cast<std::uint64_t>(cycles));
  std::vector<channels::Event> losses;
  for (channels::Event event; assembly.machine().events().pop(event);) {
    if (event.code.view() == "W720") losses.push_back(event);
  }
  ASSERT_EQ(losses.size(), 1U) << "told once";
  EXPECT_EQ(losses[0].cycle, kept + 1);
}

}  // namespace
}  // namespace stanok::daemon
